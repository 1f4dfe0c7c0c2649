#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_DIAGNOSTICS_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_DIAGNOSTICS_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "node/drive/map_driver.h"

namespace place_memory::node {

/// The mode, and what of a drive is used. ERROR while the map cannot be kept, WARN where nothing
/// that comes can be used, each for the reason.
void diagnoseDrive(const MapDriver::Health& health,
                   diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_DIAGNOSTICS_H
