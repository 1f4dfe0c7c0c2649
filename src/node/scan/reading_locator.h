#ifndef PLACE_MEMORY_NODE_SCAN_READING_LOCATOR_H
#define PLACE_MEMORY_NODE_SCAN_READING_LOCATOR_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "core/sensing/heading_history.h"
#include "core/sensing/measurement.h"
#include "node/input/reject.h"

namespace place_memory::node {

/// Where a reading was taken: by tf at its own stamp, or by the heading where there is no odometry,
/// so that a turning robot blurs nothing. It never waits.
class ReadingLocator {
 public:
  /// A sonar that looks up or down more steeply says nothing about the plane: length of its axis as
  /// seen from above.
  static constexpr double kLeastLevel = 0.1;

  /// All must outlive the locator.
  ReadingLocator(const config::Parameters& parameters, const tf2::BufferCore& buffer,
                 const core::HeadingHistory& headings)
      : parameters_(parameters), buffer_(buffer), headings_(headings) {}

  bool usesOdometry() const { return !parameters_.odom_frame.empty(); }

  struct Located {
    std::optional<Reject> reject;  ///< why there is no reading
    std::string problem;           ///< then in a sentence, where there is more to say
    core::LocatedReading reading;
  };
  Located locate(const core::Measurement& measurement) const;

  /// Whether what is missing to locate a reading may still come.
  static bool mayCome(Reject reject);

  /// Pose of the robot's base in the fixed frame; nothing where it is not known, and why, in a
  /// sentence, to `problem`.
  std::optional<core::Pose2d> baseAt(std::chrono::nanoseconds stamp, std::string& problem) const;

  /// The newest pose of the base that is known.
  struct NewestBase {
    std::chrono::nanoseconds stamp{0};
    core::Pose2d pose;
  };
  std::optional<NewestBase> newestBase() const;

 private:
  const config::Parameters& parameters_;
  const tf2::BufferCore& buffer_;
  const core::HeadingHistory& headings_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_READING_LOCATOR_H
