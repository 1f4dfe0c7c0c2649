#ifndef PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H
#define PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>

namespace place_memory::support {

/// One line that is drawn over and over.
class ProgressBar {
 public:
  /// `unit` names what is counted, as "events".
  ProgressBar(std::size_t total, std::string unit, std::ostream& output)
      : total_(total), unit_(std::move(unit)), output_(output) {}

  void show(std::size_t done);
  /// Writes a line above the bar.
  void note(const std::string& line);
  void finish() { output_ << '\n'; }

 private:
  std::size_t total_;
  std::string unit_;
  std::ostream& output_;
  std::string drawn_;
};

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H
