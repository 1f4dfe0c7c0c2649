#ifndef PLACE_MEMORY_CORE_DRIVE_PASSAGE_WATCH_H
#define PLACE_MEMORY_CORE_DRIVE_PASSAGE_WATCH_H

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// Makes traversals of the places at which a robot that drives is found, one after the other.
class PassageWatch {
 public:
  /// `source`: as of Traversal.
  explicit PassageWatch(std::string source) : source_(std::move(source)) {}

  /// The robot is at that place. Returns how it came there from another one.
  std::optional<Traversal> at(PlaceId place, std::chrono::nanoseconds stamp) {
    std::optional<Traversal> came;
    if (place_ != kNoPlace && place_ != place && left_ <= stamp) {
      came = Traversal{place_, place, left_, stamp, true, source_};
    }
    place_ = place;
    left_ = stamp;
    return came;
  }

  /// It is lost, or was carried: the next place says nothing of a way there.
  void lost() { place_ = kNoPlace; }

 private:
  std::string source_;
  PlaceId place_ = kNoPlace;
  std::chrono::nanoseconds left_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_DRIVE_PASSAGE_WATCH_H
