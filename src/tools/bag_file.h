#ifndef PLACE_MEMORY_TOOLS_BAG_FILE_H
#define PLACE_MEMORY_TOOLS_BAG_FILE_H

#include <rosbag/bag.h>
#include <rosbag/structures.h>

#include <string>

namespace place_memory::tools {

/// Opens a bag to be read. Throws std::runtime_error that says what to do where it cannot be: it is
/// not there, was never closed, is damaged, or is none.
void openBag(const std::string& path, rosbag::Bag& bag);

/// Throws std::runtime_error where a topic holds a type that is read, by another definition, whose
/// messages nobody could read.
void refuseOtherDefinition(const std::string& path, const rosbag::ConnectionInfo& connection);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_FILE_H
