#ifndef PLACE_MEMORY_TOOLS_BAG_SOURCE_H
#define PLACE_MEMORY_TOOLS_BAG_SOURCE_H

#include <rosbag/bag.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tools/bag_clock.h"
#include "tools/stored_message.h"

namespace place_memory::tools {

/// A bag that is open, and what is known of it.
struct BagSource {
  std::string path;
  std::unique_ptr<rosbag::Bag> bag;
  std::map<std::string, StampLayout> layouts;          ///< by type
  std::map<std::string, std::set<std::string>> types;  ///< by topic without slash
  std::map<std::string, std::set<std::string>> names;  ///< as the bag has it, likewise
  BagClock clock;
  std::vector<std::string> notes;  ///< what a person should know of it, in sentences

  /// As the bag has them.
  std::vector<std::string> namesOf(const std::set<std::string>& topics) const;
};

/// Opens a bag and goes through it once. `topics`, without slashes, are those to be read. Throws
/// std::runtime_error where it cannot be read, holds nothing, or has one of the topics by another
/// definition of its type.
BagSource openSource(const std::string& path, const std::set<std::string>& topics);

/// A number in a text, by the format of std::printf for it.
std::string inWords(double number, const char* format = "%.2f s");

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_SOURCE_H
