#ifndef PLACE_MEMORY_TOOLS_DRIVE_READER_H
#define PLACE_MEMORY_TOOLS_DRIVE_READER_H

#include "config/parameters.h"
#include "node/drive/drive_feed.h"
#include "tools/bag_scanner.h"
#include "tools/bag_set.h"

namespace place_memory::tools {

/// Reads whole bags in the order of the stamps in its messages, whatever the order in which they
/// were recorded. A reading comes once odometry on both sides of its stamp is known.
///
/// `scanner`: of these bags. Throws std::exception where a bag is damaged, and where the parameters
/// name no odometry.
node::DriveLosses readDrive(const BagSet& bags, BagScanner& scanner,
                            const config::Parameters& parameters, node::DriveListener& listener);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_DRIVE_READER_H
