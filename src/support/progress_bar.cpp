#include "support/progress_bar.h"

#include <unistd.h>

#include <iostream>

namespace place_memory::support {
namespace {

constexpr std::size_t kWidth = 40;

}  // namespace

bool isTerminal(const std::ostream& output) {
  if (output.rdbuf() == std::cout.rdbuf()) return isatty(STDOUT_FILENO) == 1;
  return output.rdbuf() == std::cerr.rdbuf() && isatty(STDERR_FILENO) == 1;
}

void ProgressBar::show(std::size_t done) {
  if (!terminal_) return;
  const std::size_t filled = total_ == 0 ? kWidth : kWidth * done / total_;
  drawn_ = '[' + std::string(filled, '=') + std::string(kWidth - filled, ' ') + "] " +
           std::to_string(done) + '/' + std::to_string(total_) + ' ' + unit_;
  output_ << '\r' << drawn_ << std::flush;
}

void ProgressBar::note(const std::string& line) {
  if (terminal_) output_ << '\r' << std::string(drawn_.size(), ' ') << '\r';
  output_ << line << '\n' << drawn_ << std::flush;
}

void ProgressBar::finish() {
  if (terminal_) output_ << '\n';
}

}  // namespace place_memory::support
