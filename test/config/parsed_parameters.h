#ifndef PLACE_MEMORY_TEST_CONFIG_PARSED_PARAMETERS_H
#define PLACE_MEMORY_TEST_CONFIG_PARSED_PARAMETERS_H

#include <string>
#include <vector>

#include "config/load_parameters.h"

namespace place_memory::config {

inline Parameters parse(const std::string& text) {
  return parseParameters(YAML::Load(text), "test");
}

inline std::vector<std::string> problemsOf(const std::string& text) {
  try {
    parse(text);
  } catch (const ParameterError& error) {
    return error.problems();
  }
  return {};
}

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_TEST_CONFIG_PARSED_PARAMETERS_H
