#ifndef PLACE_MEMORY_TOOLS_CLOCK_TOPIC_H
#define PLACE_MEMORY_TOOLS_CLOCK_TOPIC_H

#include <rosbag/bag.h>

#include <string>

namespace place_memory::tools {

/// Says that simulated time (/clock) came from several sources, and from which: stamps are then of
/// different times. Empty where it did not.
std::string severalClocks(const rosbag::Bag& bag);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_CLOCK_TOPIC_H
