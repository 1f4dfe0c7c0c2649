#ifndef PLACE_MEMORY_TEST_RVIZ_HOLD_WATCH_H
#define PLACE_MEMORY_TEST_RVIZ_HOLD_WATCH_H

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <string>
#include <utility>

namespace place_memory::panel {

/// The longest time for which the thread that draws did not come to its events, and how much of
/// such a time it was at work itself, in milliseconds since it was asked last.
class HoldWatch {
 public:
  HoldWatch() {
    QObject::connect(&timer_, &QTimer::timeout, [this] { note(); });
    clock_.start();
    timer_.start(5);
  }

  std::string take() {
    const std::string words = std::to_string(longest_) + " " + std::to_string(most_work_);
    longest_ = 0;
    most_work_ = 0;
    return words;
  }

 private:
  static qint64 workSoFar() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1000 * now.tv_sec + now.tv_nsec / 1'000'000;
  }

  void note() {
    longest_ = std::max(longest_, clock_.restart());
    const qint64 work = workSoFar();
    most_work_ = std::max(most_work_, work - std::exchange(work_, work));
  }

  QTimer timer_;
  QElapsedTimer clock_;
  qint64 work_ = workSoFar();
  qint64 longest_ = 0;
  qint64 most_work_ = 0;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_TEST_RVIZ_HOLD_WATCH_H
