#ifndef PLACE_MEMORY_TOOLS_BAG_SET_H
#define PLACE_MEMORY_TOOLS_BAG_SET_H

#include <ros/time.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tools/bag_source.h"
#include "tools/stamp_order.h"

namespace place_memory::tools {

/// Bags of one robot, read as one. Every time is the robot's, by which headers are stamped.
///
/// In memory are the index that rosbag makes of each bag, and what StampOrder holds: not the
/// messages.
class BagSet {
 public:
  /// Opens the bags and goes through them once. `topics` are those to be read beside tf. Throws
  /// std::runtime_error where a bag cannot be read, holds nothing, or has a topic by another
  /// definition of its type.
  BagSet(const std::vector<std::string>& paths, const std::vector<std::string>& topics);

  /// "the bag a.bag", "the bags a.bag and b.bag".
  std::string name() const;
  bool isOne() const { return sources_.size() == 1; }
  /// Types by topic, without slashes; of the topics that are not read too.
  const std::map<std::string, std::set<std::string>>& types() const { return types_; }

  ros::Time first() const;  ///< header stamp
  ros::Time last() const;
  /// That the bags hold nothing between two times, and what they hold; empty where they do.
  std::string missing(const ros::Time& start, const ros::Time& end) const;
  /// What a person should know of the bags, in sentences.
  std::vector<std::string> notes() const;

  using Visitor = std::function<void(const TimedMessage&)>;
  /// Visits, in order of time, what came on these topics from `start` to `end`; what several bags
  /// hold once. Throws std::exception where a bag is damaged.
  void read(const std::set<std::string>& topics, const ros::Time& start, const ros::Time& end,
            const Visitor& visit) const;
  /// Visits all that came on a topic, likewise. Throws std::runtime_error where a bag is damaged.
  void readAll(const std::string& topic, const Visitor& visit) const;

 private:
  void noteNeighbours(std::vector<std::string>& notes) const;

  std::vector<BagSource> sources_;  // by first stamp
  std::map<std::string, std::set<std::string>> types_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_SET_H
