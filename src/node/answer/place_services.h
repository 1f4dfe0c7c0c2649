#ifndef PLACE_MEMORY_NODE_ANSWER_PLACE_SERVICES_H
#define PLACE_MEMORY_NODE_ANSWER_PLACE_SERVICES_H

#include <place_memory/Clear.h>
#include <place_memory/GetGraph.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/ListPlaces.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/RemovePlace.h>
#include <place_memory/RenamePlace.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/answer/answer_publisher.h"
#include "node/answer/kept_scans.h"
#include "node/base/guarded_queue.h"
#include "node/drive/drive_publisher.h"
#include "node/drive/map_driver.h"
#include "node/scan/sensor_examiner.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The services that learn, recognize and edit places.
///
/// They are answered on threads of their own, matches on other ones than edits: sensor messages
/// never wait for a match, nor does an edit. Every request is answered, also one that is refused.
class PlaceServices {
 public:
  /// What the services work on; everything must outlive them.
  struct Context {
    core::PlaceMemory& memory;
    AnswerPublisher& publisher;
    const KeptScans& scans;
    SensorExaminer& examiner;
    MapDriver& driver;
    const DrivePublisher& drive_publisher;
    const config::Parameters& parameters;
    std::string store_problem;  ///< why places are not kept, a sentence for LearnPlace; empty: kept
  };

  PlaceServices(const ros::NodeHandle& private_node, const Context& context);
  /// Cancels matches that are running, and waits for the threads.
  ~PlaceServices();
  PlaceServices(const PlaceServices&) = delete;
  PlaceServices& operator=(const PlaceServices&) = delete;

 private:
  template <class Request, class Response>
  void advertise(ros::NodeHandle& node, const char* name,
                 void (PlaceServices::*answer)(const Request&, Response&));

  void learn(const LearnPlace::Request& request, LearnPlace::Response& response);
  void recognize(const RecognizePlace::Request& request, RecognizePlace::Response& response);
  /// `window` as PlaceMemory::recognize() takes it.
  void match(const core::Scan& scan, std::optional<double> window,
             RecognizePlace::Response& response);
  void list(const ListPlaces::Request& request, ListPlaces::Response& response);
  void getGraph(const GetGraph::Request& request, GetGraph::Response& response);
  void rename(const RenamePlace::Request& request, RenamePlace::Response& response);
  void remove(const RemovePlace::Request& request, RemovePlace::Response& response);
  void clear(const Clear::Request& request, Clear::Response& response);

  const Context context_;
  std::atomic<bool> cancelled_{false};

  // The spinners stop before the queues they work on go.
  GuardedQueue match_queue_{"matches"};
  GuardedQueue edit_queue_{"edits"};
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner match_spinner_;
  ros::AsyncSpinner edit_spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_PLACE_SERVICES_H
