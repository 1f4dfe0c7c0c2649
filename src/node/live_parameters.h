#ifndef PLACE_MEMORY_NODE_LIVE_PARAMETERS_H
#define PLACE_MEMORY_NODE_LIVE_PARAMETERS_H

#include <dynamic_reconfigure/server.h>
#include <place_memory/MatchConfig.h>
#include <place_memory/PlacesConfig.h>
#include <place_memory/SonarConfig.h>
#include <ros/node_handle.h>

#include <boost/thread/recursive_mutex.hpp>
#include <functional>

#include "config/parameters.h"

namespace place_memory::node {

/// Parameters that can change while the node runs: a server of dynamic_reconfigure for each table,
/// ~match, ~places and ~sonar. They are on the parameter server under the names that they have at a
/// start.
///
/// What a start would refuse is refused as a whole, with the reason in the log, and all stays as it
/// was.
class LiveParameters {
 public:
  /// Is told what holds from then on, all that came in one request at once.
  using Changed = std::function<void(const config::Parameters&)>;

  LiveParameters(const ros::NodeHandle& private_names, const config::Parameters& at_start,
                 Changed changed);

 private:
  template <class Config>
  using Server = dynamic_reconfigure::Server<Config>;

  void onMatch(MatchConfig& wanted);
  void onPlaces(PlacesConfig& wanted);
  void onSonar(SonarConfig& wanted);

  config::Parameters now_;
  const Changed changed_;
  boost::recursive_mutex mutex_;
  Server<MatchConfig> match_;
  Server<PlacesConfig> places_;
  Server<SonarConfig> sonar_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_LIVE_PARAMETERS_H
