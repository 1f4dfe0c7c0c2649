#ifndef PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H
#define PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>

namespace place_memory::support {

/// Whether a person watches: `output` is std::cout or std::cerr, and that is a terminal.
bool isTerminal(const std::ostream& output);

/// One line that is drawn over and over on a terminal; elsewhere its notes alone are written.
class ProgressBar {
 public:
  /// `unit` names what is counted, as "events".
  ProgressBar(std::size_t total, std::string unit, std::ostream& output)
      : ProgressBar(total, std::move(unit), output, isTerminal(output)) {}
  ProgressBar(std::size_t total, std::string unit, std::ostream& output, bool terminal)
      : total_(total), unit_(std::move(unit)), output_(output), terminal_(terminal) {}

  void show(std::size_t done);
  /// Writes a line above the bar.
  void note(const std::string& line);
  void finish();

 private:
  std::size_t total_;
  std::string unit_;
  std::ostream& output_;
  bool terminal_;
  std::string drawn_;
};

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_PROGRESS_BAR_H
