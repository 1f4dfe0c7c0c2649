#ifndef PLACE_MEMORY_RVIZ_PANEL_BACKEND_H
#define PLACE_MEMORY_RVIZ_PANEL_BACKEND_H

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "rviz/background_thread.h"
#include "rviz/board.h"
#include "rviz/node_link.h"
#include "rviz/service_caller.h"

namespace place_memory::panel {

/// All that the panel asks of a node. Nothing here waits for the network, whatever has become of
/// node, master or robot; every function is for rviz's thread.
class PanelBackend {
 public:
  PanelBackend();
  PanelBackend(const PanelBackend&) = delete;
  PanelBackend& operator=(const PanelBackend&) = delete;
  ~PanelBackend();

  /// Full name, e.g. "/place_memory".
  void choose(const std::string& node);
  const std::string& node() const { return node_; }

  /// To be called some ten times a second: looks for the node, lets go of calls and goals that are
  /// not answered, and gets the map where it is wanted. What is to be shown, if that has changed.
  std::optional<PanelView> poll();

  void scan();
  void goTo(const std::string& label);
  /// Until nothing is left, and home again.
  void explore();
  void learn(const std::string& label);
  void recognize();
  void relocalize();
  void setMode(const std::string& mode);
  void rename(const std::string& label, const std::string& new_label);
  void remove(const std::string& label);
  void undo();
  /// Paths are below the node's parameter store_directory.
  void save(const std::string& path);
  void load(const std::string& path);
  /// Every goal that is under way.
  void cancel();

 private:
  struct Link {
    std::unique_ptr<NodeLink> node;
  };

  void look();
  void link();
  void askForGraph();
  void withLink(const std::function<void(NodeLink&)>& use);
  void leaveNode();
  template <class Service>
  void call(const std::string& service, const typename Service::Request& request,
            std::chrono::seconds patience);

  std::string node_;
  std::shared_ptr<Board> board_;
  std::shared_ptr<Link> link_;  // used on links_ alone
  bool is_linked_ = false;
  std::shared_ptr<ServiceCaller> caller_;
  std::shared_ptr<std::atomic<bool>> is_looking_;
  std::chrono::steady_clock::time_point looked_;      // was to be looked, newest
  std::chrono::steady_clock::time_point look_begun_;  // the newest one
  BackgroundThread links_;
  BackgroundThread watch_;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PANEL_BACKEND_H
