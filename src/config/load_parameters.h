#ifndef PLACE_MEMORY_CONFIG_LOAD_PARAMETERS_H
#define PLACE_MEMORY_CONFIG_LOAD_PARAMETERS_H

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "place_memory/config/parameter_error.h"

namespace place_memory::config {

/// Parameters of a table laid out as config/place_memory.yaml, the defaults where it is silent.
/// `source` is named in problems. Throws ParameterError with every parameter that is unknown, given
/// twice, mistyped, not finite or out of range, and with what is wrong with the preset file.
Parameters parseParameters(const YAML::Node& table, const std::string& source);

/// Parameters of YAML files: where several give one, the last of them holds. Throws ParameterError,
/// also for files that cannot be read.
Parameters loadParameters(const std::vector<std::string>& paths);

/// The name of every parameter, as "scan/step".
std::set<std::string> parameterNames();

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_LOAD_PARAMETERS_H
