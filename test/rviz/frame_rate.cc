// How fast rviz draws: shows a configuration in a window, and says how many frames there were.
// usage: frame_rate CONFIGURATION WIDTH HEIGHT SECONDS PICTURE
// Lines: frames a second; of these seconds the share in which rviz's own thread was at work. Counts
// from the time on when SECONDS have passed, so that all has come that is to be drawn, and writes
// the picture at the end.
#include <ros/init.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QScreen>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>

namespace {

double workSoFar() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "frame_rate");
  if (argc != 6) {
    std::cerr << "usage: frame_rate CONFIGURATION WIDTH HEIGHT SECONDS PICTURE\n";
    return 2;
  }
  QApplication application(argc, argv);
  rviz::VisualizationFrame frame;
  frame.setSplashPath("");
  frame.initialize(QString::fromLocal8Bit(argv[1]));
  frame.setGeometry(0, 0, std::atoi(argv[2]), std::atoi(argv[3]));
  frame.show();
  const int pause = 1000 * std::atoi(argv[4]);
  std::uint64_t frames = 0;
  double work = 0.0;
  QElapsedTimer clock;
  QTimer::singleShot(pause, [&] {
    frames = frame.getManager()->getFrameCount();
    work = workSoFar();
    clock.start();
  });
  QTimer::singleShot(2 * pause, [&] {
    const double seconds = static_cast<double>(clock.elapsed()) / 1000.0;
    const auto drawn = static_cast<double>(frame.getManager()->getFrameCount() - frames);
    std::cout << drawn / seconds << "\n" << (workSoFar() - work) / seconds << std::endl;
    application.primaryScreen()->grabWindow(frame.winId()).save(QString::fromLocal8Bit(argv[5]));
    application.quit();
  });
  return application.exec();
}
