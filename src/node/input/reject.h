#ifndef PLACE_MEMORY_NODE_INPUT_REJECT_H
#define PLACE_MEMORY_NODE_INPUT_REJECT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace place_memory::node {

/// Why a reading is left out of a scan.
enum class Reject {
  kNan,            ///< range is NaN
  kTooClose,       ///< range is -inf: something nearer than min_range; no cell is touched
  kBelowMinRange,  ///< finite
  kAboveMaxRange,  ///< finite
  kFixedDistance,  ///< finite, from a sensor whose min_range is its max_range (REP 117)
  kBadSensor,      ///< the sensor's own limits make no sense
  kNoStamp,        ///< stamp is 0
  kOld,            ///< stamped long before the message came or before the sensor's newest reading
  kNoMount,        ///< nothing says yet where a cloud's sensor looks
  kVertical,       ///< the sensor looks up or down
  kNoTransform,    ///< of the sensor at its stamp
  kNoOdometry,     ///< at its stamp
  kNoHeading,      ///< at its stamp
  kScanFull,       ///< the scan holds as many readings as it may
};
constexpr std::size_t kRejects = static_cast<std::size_t>(Reject::kScanFull) + 1;

/// In a few words for people, e.g. "no transform".
const char* toString(Reject reject);

/// What a person may do about it, e.g. "is its clock right?".
const char* adviceOn(Reject reject);

/// By Reject.
using RejectCounts = std::array<std::uint32_t, kRejects>;

/// The reason there is most of; the first one where there is none.
Reject mostFrequent(const RejectCounts& rejected);

/// The counts that are not 0, e.g. "2 no stamp, 1 no heading"; empty where all are.
std::string inWords(const RejectCounts& rejected);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_REJECT_H
