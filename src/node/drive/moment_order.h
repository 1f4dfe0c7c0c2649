#ifndef PLACE_MEMORY_NODE_DRIVE_MOMENT_ORDER_H
#define PLACE_MEMORY_NODE_DRIVE_MOMENT_ORDER_H

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "node/drive/drive_moment.h"

namespace place_memory::node {

/// Puts the moments of a live drive into their order, which is that of their stamps: however fast
/// they come, and whichever input is ahead.
///
/// A moment is let go once every input has come further, or it has waited so long that what might
/// still come before it is lost. An input is what one sensor, one transform or the compass says.
/// Not thread-safe.
class MomentOrder {
 public:
  /// An input that is behind is waited for so long, by a clock that nobody sets.
  static constexpr std::chrono::nanoseconds kPatience = std::chrono::milliseconds(500);
  /// One that is silent for so long is not waited for.
  static constexpr std::chrono::nanoseconds kSilence = std::chrono::seconds(5);

  /// `steady`: now, by a clock that nobody sets. False where the moment comes too late.
  bool add(DriveMoment moment, std::chrono::nanoseconds steady);
  /// Those that can be let go by now, in their order.
  std::vector<DriveMoment> take(std::chrono::nanoseconds steady);
  /// Forgets all of them: time has jumped.
  void clear();

  std::size_t waiting() const { return waiting_.size(); }

 private:
  using Input = std::pair<std::size_t, std::string>;  // kind and frame
  struct Newest {
    std::chrono::nanoseconds stamp{0};
    std::chrono::nanoseconds heard{0};  // steady
  };
  struct Arrival {
    std::chrono::nanoseconds steady{0};
    std::chrono::nanoseconds stamp{0};
  };

  std::multiset<DriveMoment> waiting_;
  std::deque<Arrival> arrivals_;
  std::map<Input, Newest> inputs_;
  std::chrono::nanoseconds begun_{-1};    // steady; when the first moment came
  std::chrono::nanoseconds overdue_{-1};  // newest stamp that has waited for long enough
  std::chrono::nanoseconds let_go_{-1};   // newest stamp that was let go
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_MOMENT_ORDER_H
