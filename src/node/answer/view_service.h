#ifndef PLACE_MEMORY_NODE_ANSWER_VIEW_SERVICE_H
#define PLACE_MEMORY_NODE_ANSWER_VIEW_SERVICE_H

#include <place_memory/SuggestView.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <string>

#include "node/base/guarded_queue.h"
#include "node/go/view_asker.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The service ~suggest_view. It is answered on a thread of its own, because it may wait for the
/// disk.
class ViewService {
 public:
  /// All have to outlive it.
  ViewService(const ros::NodeHandle& private_node, const core::PlaceMemory& memory,
              const ViewAsker& asker);
  /// Waits for the thread.
  ~ViewService();
  ViewService(const ViewService&) = delete;
  ViewService& operator=(const ViewService&) = delete;

 private:
  void suggest(const SuggestView::Request& request, SuggestView::Response& response);
  void fill(const ViewAsker::Asked& asked, SuggestView::Response& response) const;
  std::string labelOf(core::PlaceId id) const;

  const core::PlaceMemory& memory_;
  const ViewAsker& asker_;
  // The spinner stops before the queue it works on goes.
  GuardedQueue queue_{"views"};
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_VIEW_SERVICE_H
