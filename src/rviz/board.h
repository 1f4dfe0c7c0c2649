#ifndef PLACE_MEMORY_RVIZ_BOARD_H
#define PLACE_MEMORY_RVIZ_BOARD_H

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "rviz/panel_state.h"

namespace place_memory::panel {

/// The state of one node, written by the threads that hear of it and read by the one that draws.
class Board {
 public:
  explicit Board(const std::string& node) : state_(node) {}

  /// Whatever `change(state)` returns.
  template <class Change>
  auto change(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++version_;
    return change(state_);
  }

  /// Whatever `read(state)` returns, which changes nothing.
  template <class Read>
  auto read(const Read& read) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return read(state_);
  }

  /// What is to be shown, if that has changed since it was asked for last.
  std::optional<PanelView> news() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (seen_ == version_) return std::nullopt;
    seen_ = version_;
    return state_.view();
  }

 private:
  mutable std::mutex mutex_;
  PanelState state_;
  std::uint64_t version_ = 1;
  std::uint64_t seen_ = 0;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_BOARD_H
