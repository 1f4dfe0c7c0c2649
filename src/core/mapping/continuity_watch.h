#ifndef PLACE_MEMORY_CORE_MAPPING_CONTINUITY_WATCH_H
#define PLACE_MEMORY_CORE_MAPPING_CONTINUITY_WATCH_H

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/mapping/moving_scan.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// How readings go on at a spot of the way.
enum class Continuity {
  kUnseen,       ///< too little is known of what is on both sides
  kGoesOn,       ///< as they do everywhere
  kFalters,      ///< less than they mostly do
  kBreaks,       ///< hardly
  kSurelyBreaks  ///< not at all
};

constexpr std::size_t kContinuities = 5;

/// How the compass turns there.
enum class CompassTurn {
  kUnseen,      ///< there is none
  kAsOdometry,  ///< or so nearly that it may be iron
  kOtherwise
};

constexpr std::size_t kCompassTurns = 3;

/// The least continuous spot of a piece of the way.
struct Spot {
  Continuity readings = Continuity::kUnseen;
  CompassTurn compass = CompassTurn::kUnseen;
  double way = 0.0;  ///< [m]
};

/// Compares the readings after each spot of the way with those before it, laid out along odometry.
/// A robot that is lifted and put down elsewhere goes on without a jump in odometry, but what it
/// senses does not go on; that shows on new ground too.
class ContinuityWatch {
 public:
  /// In the order of stamps; the reading is in the base's frame. `heading`: the compass' [rad].
  void add(const BaseMoment& moment, const SonarReading& reading, std::optional<double> heading);
  /// Of the spots that were judged since it was asked last; a spot is judged when the robot is half
  /// a metre further.
  Spot take();
  /// Forgets all readings, but not how well they mostly go on.
  void restart();

 private:
  /// A reading in odometry's frame.
  struct Ray {
    double x, y;          ///< of the sensor [m]
    double cosine, sine;  ///< of its direction
    double half_cosine;   ///< of half its opening angle
    double range;         ///< [m]; infinite: no echo
    double free;          ///< nothing is so far [m]
  };
  /// Readings from one spot.
  struct Station {
    double way;
    double yaw;                       ///< of odometry [rad]
    std::optional<double> deviation;  ///< of the compass from that [rad]
    std::vector<Ray> rays;
  };
  /// What is compared with the other side of a spot.
  struct Side {
    std::vector<Ray> rays;
    std::optional<double> deviation;  ///< a mean [rad]
  };
  /// Echoes that the other side explains, and echoes where it found nothing.
  struct Fit {
    int explained = 0;
    int intruding = 0;
  };

  static void count(const std::vector<Ray>& echoes, const std::vector<Ray>& others, Fit& fit);
  Side side(std::size_t first, std::size_t last) const;
  void judge(std::size_t station);

  std::deque<Station> stations_;
  std::size_t next_ = 0;  ///< station to be judged
  double usual_ = 0.3;    ///< share of echoes that intrude, as a running mean of worst spots
  double spread_ = 0.0;   ///< mean distance of their log odds from that
  /// Of the spots since it was asked last.
  std::optional<double> worst_;   ///< share of echoes that intrude
  double worst_way_ = 0.0;        ///< of that spot [m]
  std::optional<double> turned_;  ///< by the compass beyond odometry, at most [rad]
  double turned_way_ = 0.0;       ///< of that spot [m]
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_CONTINUITY_WATCH_H
