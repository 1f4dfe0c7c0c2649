#include "node/parameter_server.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

YAML::Node tagged(const std::string& text, const char* tag) {
  YAML::Node node(text);
  node.SetTag(tag);
  return node;
}

YAML::Node quoted(const std::string& text) { return tagged(text, "!"); }

YAML::Node number(double value) {
  // The words of YAML: nan and inf are texts there.
  if (std::isnan(value)) return YAML::Node(".nan");
  if (std::isinf(value)) return YAML::Node(value > 0.0 ? ".inf" : "-.inf");
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return YAML::Node(text.str());
}

void removeForeign(YAML::Node& table) {
  if (!table.IsMap()) return;
  table.remove("diagnostic_period");
  table.remove("diagnostic_updater");
  YAML::Node scan = table[kScanAction];
  if (!scan.IsMap()) {
    if (!scan.IsDefined() || scan.IsNull()) table.remove(kScanAction);
    return;
  }
  for (const char* name : {"status_frequency", "status_list_timeout",
                           "actionlib_server_pub_queue_size", "actionlib_server_sub_queue_size"}) {
    scan.remove(name);
  }
}

}  // namespace

YAML::Node toYaml(const XmlRpc::XmlRpcValue& value) {
  // Reading a value is not const in XmlRpc.
  XmlRpc::XmlRpcValue copy = value;
  YAML::Node node;
  switch (copy.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(copy));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(copy));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return number(static_cast<double>(copy));
    case XmlRpc::XmlRpcValue::TypeString:
      return quoted(static_cast<std::string>(copy));
    case XmlRpc::XmlRpcValue::TypeArray:
      node = YAML::Node(YAML::NodeType::Sequence);
      // begin() and end() of an XmlRpcValue are those of a struct.
      for (int i = 0; i < copy.size(); ++i) {  // NOLINT(modernize-loop-convert)
        node.push_back(toYaml(copy[i]));
      }
      return node;
    case XmlRpc::XmlRpcValue::TypeStruct:
      node = YAML::Node(YAML::NodeType::Map);
      for (auto& [name, member] : copy) node[name] = toYaml(member);
      return node;
    case XmlRpc::XmlRpcValue::TypeDateTime:
      return tagged("dateTime.iso8601", "tag:yaml.org,2002:timestamp");
    case XmlRpc::XmlRpcValue::TypeBase64:
      return tagged("base64", "tag:yaml.org,2002:binary");
    default:
      return YAML::Node(YAML::NodeType::Null);
  }
}

config::Parameters readPrivateParameters(const ros::NodeHandle& private_names) {
  XmlRpc::XmlRpcValue values;
  YAML::Node table;
  if (private_names.getParam(private_names.getNamespace(), values)) table = toYaml(values);
  removeForeign(table);
  return config::parseParameters(table, private_names.getNamespace());
}

}  // namespace place_memory::node
