#ifndef PLACE_MEMORY_TOOLS_DRIVE_RUN_H
#define PLACE_MEMORY_TOOLS_DRIVE_RUN_H

#include <string>

#include "config/parameters.h"
#include "tools/bag_scanner.h"
#include "tools/bag_set.h"

namespace place_memory::tools {

/// What is made of a drive. Paths of tables that are not wanted are empty.
struct DriveArguments {
  std::string mode;        ///< map or localize
  std::string trajectory;  ///< where the robot is, as map -> odom said at each moment
  std::string final_way;   ///< the same way once more, as the map lies at the end
  std::string map;         ///< the places
  std::string answers;     ///< what became of each scan
  std::string png;         ///< picture of the building, its places and links, and the way
};

/// Drives the way of bags along with a map: one that it makes, and takes up and keeps in
/// `parameters.store` where that is not empty, or one that only tells where the robot is. Says on
/// `std::cerr` what came of it.
///
/// Throws std::runtime_error where a bag, the store or a table cannot be read or written.
void runDrive(const BagSet& bags, BagScanner& scanner, const DriveArguments& arguments,
              const config::Parameters& parameters);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_DRIVE_RUN_H
