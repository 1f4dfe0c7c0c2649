#ifndef PLACE_MEMORY_CONFIG_RENAMED_PARAMETERS_H
#define PLACE_MEMORY_CONFIG_RENAMED_PARAMETERS_H

#include <map>
#include <string>

namespace place_memory::config {

/// The parameters of former versions that have another name now, by their old names. An old name
/// is refused, and the error says the new one. No name has changed yet.
inline std::map<std::string, std::string> renamedParameters() { return {}; }

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_RENAMED_PARAMETERS_H
