#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_TOPICS_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_TOPICS_H

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/scan/scan_status.h"

namespace place_memory::node {

/// `parameters` with the topics of sonars, compass and odometry as `names` resolves them.
config::Parameters withResolvedTopics(const ros::NodeHandle& names,
                                      const config::Parameters& parameters);

/// Sentences on names that were remapped, as by an argument of launch/place_memory.launch, though
/// nothing of those names is listened to, since a parameter says otherwise.
std::vector<std::string> vainRemappings(const ros::NodeHandle& names,
                                        const config::Parameters& parameters);

/// Says in the log which topics and frames are used, and what vainRemappings() has to say.
void sayTopics(const ros::NodeHandle& names, const config::Parameters& parameters);

/// Says in the log how a scan ended.
void sayOutcome(const ScanOutcome& outcome);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_TOPICS_H
