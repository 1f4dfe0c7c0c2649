#ifndef PLACE_MEMORY_NODE_ANSWER_STORE_SERVICES_H
#define PLACE_MEMORY_NODE_ANSWER_STORE_SERVICES_H

#include <place_memory/Export.h>
#include <place_memory/Load.h>
#include <place_memory/Merge.h>
#include <place_memory/Save.h>
#include <place_memory/Undo.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <vector>

#include "config/parameters.h"
#include "node/answer/answer_publisher.h"
#include "node/base/guarded_queue.h"
#include "node/drive/map_driver.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The services by which maps come from files and go into them, and by which changes are undone.
///
/// They are answered on a thread of their own: nobody else waits for a long copy. Files lie below
/// the parameter store_directory. Every request is answered, also one that is refused.
class StoreServices {
 public:
  /// What is given must outlive the services.
  StoreServices(const ros::NodeHandle& private_node, core::PlaceMemory& memory, MapDriver& driver,
                AnswerPublisher& publisher, const config::Parameters& parameters);
  /// Waits for the thread.
  ~StoreServices();
  StoreServices(const StoreServices&) = delete;
  StoreServices& operator=(const StoreServices&) = delete;

 private:
  void save(const Save::Request& request, Save::Response& response);
  void load(const Load::Request& request, Load::Response& response);
  void merge(const Merge::Request& request, Merge::Response& response);
  void exportMap(const Export::Request& request, Export::Response& response);
  void undo(const Undo::Request& request, Undo::Response& response);

  core::PlaceMemory& memory_;
  MapDriver& driver_;
  AnswerPublisher& publisher_;
  const config::Parameters& parameters_;

  // The spinner stops before the queue it works on goes.
  GuardedQueue queue_{"maps from and to files"};
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_STORE_SERVICES_H
