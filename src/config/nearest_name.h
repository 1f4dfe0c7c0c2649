#ifndef PLACE_MEMORY_CONFIG_NEAREST_NAME_H
#define PLACE_MEMORY_CONFIG_NEAREST_NAME_H

#include <set>
#include <string>

namespace place_memory::config {

/// The known name that was probably meant: the one that ends it, or that few letters part from it
/// (V. I. Levenshtein's distance, 1966); "" where none is like it.
std::string nearestName(const std::string& name, const std::set<std::string>& known);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_NEAREST_NAME_H
