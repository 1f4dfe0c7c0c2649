#ifndef PLACE_MEMORY_NODE_PARAMETER_SERVER_H
#define PLACE_MEMORY_NODE_PARAMETER_SERVER_H

#include <XmlRpcValue.h>
#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include "config/load_parameters.h"

namespace place_memory::node {

/// The same value in YAML; texts are in quotes, so that "5" does not become a number.
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value);

/// The node's private parameters by the one parser there is. Those that actionlib and
/// diagnostic_updater read in the same namespace are left to them. Throws config::ParameterError.
config::Parameters readPrivateParameters(const ros::NodeHandle& private_names);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_PARAMETER_SERVER_H
