#include "rviz/node_link.h"

#include <std_msgs/String.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>

#include <boost/function.hpp>

#include "node/names/node_names.h"

namespace place_memory::panel {
namespace {

constexpr int kQueueLength = 100;

/// Lets `change(state, message)` happen with each message of a topic.
template <class Message, class Change>
ros::Subscriber write(ros::NodeHandle& names, const std::string& topic,
                      const std::shared_ptr<Board>& board, const Change& change) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> on_message =
      [board, change](const boost::shared_ptr<const Message>& message) {
        board->change([&](PanelState& state) { change(state, *message); });
      };
  return names.subscribe<Message>(topic, kQueueLength, on_message);
}

}  // namespace

NodeLink::NodeLink(const std::string& node, const std::shared_ptr<Board>& board)
    : spinner_(1, &queue_) {
  names_.setCallbackQueue(&queue_);
  const std::string below = node + "/";
  subscribers_ = {
      write<MapChange>(names_, below + node::kMapChangesTopic, board,
                       [](PanelState& state, const MapChange& change) { state.addChange(change); }),
      write<Recognition>(
          names_, below + node::kRecognitionTopic, board,
          [](PanelState& state, const Recognition& answer) { state.setRecognition(answer); }),
      write<PlaceBelief>(
          names_, below + node::kBeliefTopic, board,
          [](PanelState& state, const PlaceBelief& belief) { state.setBelief(belief); }),
      write<std_msgs::String>(
          names_, below + node::kModeTopic, board,
          [](PanelState& state, const std_msgs::String& mode) { state.setMode(mode.data); }),
      write<MapEvent>(names_, below + node::kEventsTopic, board,
                      [](PanelState& state, const MapEvent& event) { state.addEvent(event); }),
      write<visualization_msgs::InteractiveMarkerFeedback>(
          names_, below + node::kPlaceHandlesTopic + "/feedback", board,
          [](PanelState& state, const visualization_msgs::InteractiveMarkerFeedback& feedback) {
            state.hearClick(feedback);
          }),
  };
  scan_ = std::make_unique<ActionLink<ScanPlaceAction>>(names_, node, node::kScanAction, board);
  go_to_place_ =
      std::make_unique<ActionLink<GoToPlaceAction>>(names_, node, node::kGoToPlaceAction, board);
  explore_ = std::make_unique<ActionLink<ExploreAction>>(names_, node, node::kExploreAction, board);
  spinner_.start();
}

NodeLink::~NodeLink() { spinner_.stop(); }

void NodeLink::cancel() {
  scan_->cancel();
  go_to_place_->cancel();
  explore_->cancel();
}

}  // namespace place_memory::panel
