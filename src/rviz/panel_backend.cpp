#include "rviz/panel_backend.h"

#include <place_memory/GetGraph.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/Load.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/Relocalize.h>
#include <place_memory/RemovePlace.h>
#include <place_memory/RenamePlace.h>
#include <place_memory/Save.h>
#include <place_memory/SetMode.h>
#include <place_memory/Undo.h>
#include <ros/init.h>

#include <utility>

#include "node/names/node_names.h"

namespace place_memory::panel {
namespace {

constexpr std::chrono::seconds kLookPeriod(1);
constexpr std::chrono::seconds kLookPatience(5);
constexpr std::chrono::seconds kPatience(15);      // with a service
constexpr std::chrono::seconds kLongPatience(60);  // with one that goes through the whole map

std::string endInWords(CallEnd end, const std::string& service, std::chrono::seconds patience) {
  if (end == CallEnd::kTimedOut) {
    return "~" + service + " has not answered within " + std::to_string(patience.count()) +
           " s; whether it did what was asked is not known";
  }
  return "~" + service + " cannot be reached";
}

}  // namespace

PanelBackend::PanelBackend() { choose("/place_memory"); }

PanelBackend::~PanelBackend() { leaveNode(); }

void PanelBackend::choose(const std::string& node) {
  leaveNode();
  node_ = node;
  board_ = std::make_shared<Board>(node);
  caller_ = std::make_shared<ServiceCaller>();
  link_ = std::make_shared<Link>();
  is_linked_ = false;
  is_looking_ = std::make_shared<std::atomic<bool>>(false);
  looked_ = {};
}

void PanelBackend::leaveNode() {
  if (!link_) return;
  // What is still under way writes on that node's board, which nobody reads any more.
  links_.post([link = std::move(link_), caller = std::move(caller_)]() mutable {
    caller.reset();
    link->node.reset();
  });
}

std::optional<PanelView> PanelBackend::poll() {
  const auto now = ServiceCaller::Clock::now();
  caller_->expire(now);
  if (now - looked_ >= kLookPeriod) {
    looked_ = now;
    board_->change([now](PanelState& state) { state.giveUpGoals(now); });
    look();
    askForGraph();
  }
  link();
  return board_->news();
}

void PanelBackend::look() {
  const auto now = ServiceCaller::Clock::now();
  if (is_looking_->exchange(true)) {
    if (now - look_begun_ < kLookPatience) return;
    // The network keeps the last look waiting: so it would do with all else.
    Presence away;
    away.kind = Presence::Kind::kAway;
    board_->change([&away](PanelState& state) { state.setPresence(away); });
    return;
  }
  look_begun_ = now;
  watch_.post([node = node_, board = board_, is_looking = is_looking_] {
    const Presence presence = lookFor(node);
    board->change([&presence](PanelState& state) { state.setPresence(presence); });
    *is_looking = false;
  });
}

void PanelBackend::link() {
  // Without a master ROS would wait for one, and hold up whoever closes rviz.
  const auto has_master = [](const PanelState& state) { return state.hasMaster(); };
  if (is_linked_ || !board_->read(has_master)) return;
  is_linked_ = true;
  links_.post([link = link_, board = board_, node = node_] {
    if (ros::ok()) link->node = std::make_unique<NodeLink>(node, board);
  });
}

void PanelBackend::askForGraph() {
  const bool is_wanted = board_->change([](PanelState& state) { return state.beginGraph(); });
  if (!is_wanted) return;
  const ServiceCaller::OnEnd<GetGraph> on_end = [board = board_](CallEnd end,
                                                                 const GetGraph::Response& answer) {
    board->change([&](PanelState& state) {
      if (end != CallEnd::kAnswered) {
        state.failGraph(endInWords(end, node::kGetGraphService, kLongPatience));
      } else if (answer.status != GetGraph::Response::OK) {
        state.failGraph(answer.message);
      } else {
        state.setGraph(answer.graph);
      }
    });
  };
  caller_->call<GetGraph>(node_ + "/" + node::kGetGraphService, {}, kLongPatience, on_end);
}

template <class Service>
void PanelBackend::call(const std::string& service, const typename Service::Request& request,
                        std::chrono::seconds patience) {
  board_->change([&service](PanelState& state) { state.beginCall(service); });
  const auto on_end = [board = board_, service, patience](
                          CallEnd end, const typename Service::Response& answer) {
    const bool answered = end == CallEnd::kAnswered;
    const std::string words = answered ? answer.message : endInWords(end, service, patience);
    const bool done = answered && answer.status == Service::Response::OK;
    board->change([&](PanelState& state) { state.endCall(service, words, !done); });
  };
  caller_->call<Service>(node_ + "/" + service, request, patience, on_end);
}

void PanelBackend::withLink(const std::function<void(NodeLink&)>& use) {
  links_.post([link = link_, use] {
    if (link->node) use(*link->node);
  });
}

void PanelBackend::scan() {
  withLink([](NodeLink& link) { link.scan().send({}); });
}

void PanelBackend::goTo(const std::string& label) {
  GoToPlaceGoal goal;
  goal.label = label;
  withLink([goal](NodeLink& link) { link.goToPlace().send(goal); });
}

void PanelBackend::explore() {
  withLink([](NodeLink& link) { link.explore().send({}); });
}

void PanelBackend::cancel() {
  withLink([](NodeLink& link) { link.cancel(); });
}

void PanelBackend::learn(const std::string& label) {
  LearnPlace::Request request;
  request.label = label;
  call<LearnPlace>(node::kLearnPlaceService, request, kPatience);
}

void PanelBackend::recognize() {
  call<RecognizePlace>(node::kRecognizePlaceService, {}, kLongPatience);
}

void PanelBackend::relocalize() { call<Relocalize>(node::kRelocalizeService, {}, kPatience); }

void PanelBackend::setMode(const std::string& mode) {
  SetMode::Request request;
  request.mode = mode;
  call<SetMode>(node::kSetModeService, request, kLongPatience);
}

void PanelBackend::rename(const std::string& label, const std::string& new_label) {
  RenamePlace::Request request;
  request.label = label;
  request.new_label = new_label;
  call<RenamePlace>(node::kRenamePlaceService, request, kPatience);
}

void PanelBackend::remove(const std::string& label) {
  RemovePlace::Request request;
  request.label = label;
  call<RemovePlace>(node::kRemovePlaceService, request, kPatience);
}

void PanelBackend::undo() { call<Undo>(node::kUndoService, {}, kPatience); }

void PanelBackend::save(const std::string& path) {
  Save::Request request;
  request.path = path;
  call<Save>(node::kSaveService, request, kLongPatience);
}

void PanelBackend::load(const std::string& path) {
  Load::Request request;
  request.path = path;
  call<Load>(node::kLoadService, request, kLongPatience);
}

}  // namespace place_memory::panel
