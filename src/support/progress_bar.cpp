#include "support/progress_bar.h"

namespace place_memory::support {
namespace {

constexpr std::size_t kWidth = 40;

}  // namespace

void ProgressBar::show(std::size_t done) {
  const std::size_t filled = total_ == 0 ? kWidth : kWidth * done / total_;
  drawn_ = '[' + std::string(filled, '=') + std::string(kWidth - filled, ' ') + "] " +
           std::to_string(done) + '/' + std::to_string(total_) + ' ' + unit_;
  output_ << '\r' << drawn_ << std::flush;
}

void ProgressBar::note(const std::string& line) {
  output_ << '\r' << std::string(drawn_.size(), ' ') << '\r' << line << '\n'
          << drawn_ << std::flush;
}

}  // namespace place_memory::support
