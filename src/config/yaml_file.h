#ifndef PLACE_MEMORY_CONFIG_YAML_FILE_H
#define PLACE_MEMORY_CONFIG_YAML_FILE_H

#include <yaml-cpp/yaml.h>

#include <string>

namespace place_memory::config {

/// The one document of a YAML file in UTF-8, with a byte order mark or without. Throws
/// ParameterError that names the file and what is wrong: cannot be read, another encoding, tabs
/// that indent, no YAML, several documents.
YAML::Node loadYamlFile(const std::string& path);

/// The same of a text; `source` is named in problems.
YAML::Node loadYamlText(const std::string& bytes, const std::string& source);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_YAML_FILE_H
