#include "rviz/presence.h"

#include <ros/master.h>
#include <ros/names.h>
#include <ros/service.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <optional>

#include "node/names/node_names.h"

namespace place_memory::panel {
namespace {

/// The names in one of the three lists of getSystemState, each an array of name and nodes.
std::set<std::string> namesIn(XmlRpc::XmlRpcValue list) {
  std::set<std::string> names;
  for (int i = 0; i < list.size(); ++i) names.insert(std::string(list[i][0]));
  return names;
}

/// What follows `prefix` in each name that begins with it.
std::set<std::string> below(const std::string& prefix, const std::set<std::string>& names) {
  std::set<std::string> found;
  for (auto name = names.lower_bound(prefix);
       name != names.end() && name->compare(0, prefix.size(), prefix) == 0; ++name) {
    found.insert(name->substr(prefix.size()));
  }
  return found;
}

/// What comes before `suffix` in each name that ends with it.
std::vector<std::string> before(const std::string& suffix, const std::set<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (name.size() <= suffix.size()) continue;
    const std::size_t rest = name.size() - suffix.size();
    if (name.compare(rest, suffix.size(), suffix) == 0) found.push_back(name.substr(0, rest));
  }
  return found;
}

/// Where a service is answered, once something was reached there. A node that was killed stays
/// known to the master.
std::optional<std::string> reach(const std::string& service) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::ServiceManager::instance()->lookupService(service, host, port)) return std::nullopt;
  if (!ros::service::exists(service, false)) return std::nullopt;
  return host + ":" + std::to_string(port);
}

}  // namespace

Presence lookFor(const std::string& node) {
  Presence presence;
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) {
    presence.kind = Presence::Kind::kNoMaster;
    return presence;
  }
  const std::set<std::string> services = namesIn(state[2]);
  presence.nodes = before(std::string("/") + node::kGetGraphService, services);
  const std::optional<std::string> place = reach(node + "/" + node::kGetGraphService);
  presence.kind = place ? Presence::Kind::kThere : Presence::Kind::kAway;
  if (!place) return presence;
  presence.incarnation = *place;
  presence.services = below(node + "/", services);
  for (const std::string& topic : below(node + "/", namesIn(state[1]))) {
    for (const std::string& action : before("/goal", {topic})) presence.actions.insert(action);
  }
  return presence;
}

}  // namespace place_memory::panel
