#ifndef PLACE_MEMORY_CONFIG_YAML_VALUE_H
#define PLACE_MEMORY_CONFIG_YAML_VALUE_H

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "place_memory/core/pose2d.h"

namespace place_memory::config {

/// What roslaunch and rosparam take a value for, by YAML 1.1, which differs from the rules of
/// yaml-cpp: 010 is eight, 1:30 is ninety, `y` is a text, deg(2) is a number.
enum class ValueKind { kNothing, kFlag, kNumber, kText, kDate, kBinary, kList, kTable, kForeign };

/// kForeign: a tag that YAML does not know.
ValueKind kindOf(const YAML::Node& node);

/// The number of a value, also of a text that is meant as one though YAML 1.1 knows it only as a
/// text (1e-2, pi/2): whoever asks for a number gets the same from a file as from the parameter
/// server, where roslaunch puts it as a text. Nothing where it is no number.
std::optional<double> numberOf(const YAML::Node& node);

std::optional<bool> flagOf(const YAML::Node& node);

/// A list [x, y, yaw] of three numbers [m, m, rad], none larger than 100; nothing where it is none.
std::optional<core::Pose2d> poseOf(const YAML::Node& node);

/// The value in a sentence, as 'many' or "a list".
std::string shown(const YAML::Node& node);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_YAML_VALUE_H
