#include "rviz/node_link.h"

#include <std_msgs/String.h>

#include <boost/function.hpp>

#include "rviz/interface_names.h"

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
      write<MapChange>(names_, below + kMapChangesTopic, board,
                       [](PanelState& state, const MapChange& change) { state.addChange(change); }),
      write<Recognition>(
          names_, below + kRecognitionTopic, board,
          [](PanelState& state, const Recognition& answer) { state.setRecognition(answer); }),
      write<PlaceBelief>(
          names_, below + kBeliefTopic, board,
          [](PanelState& state, const PlaceBelief& belief) { state.setBelief(belief); }),
      write<std_msgs::String>(
          names_, below + kModeTopic, board,
          [](PanelState& state, const std_msgs::String& mode) { state.setMode(mode.data); }),
      write<MapEvent>(names_, below + kEventsTopic, board,
                      [](PanelState& state, const MapEvent& event) { state.addEvent(event); }),
  };
  scan_ = std::make_unique<ActionLink<ScanPlaceAction>>(names_, node, kScanAction, board);
  spinner_.start();
}

NodeLink::~NodeLink() { spinner_.stop(); }

}  // namespace place_memory::panel
