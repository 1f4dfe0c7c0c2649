#include "experiments/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "experiments/statistics.h"
#include "support/csv.h"

namespace place_memory::experiments {

void Table::writeMarkdown(std::ostream& output) const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    output << '|';
    for (std::size_t i = 0; i < widths.size(); ++i) {
      output << ' ' << rows_[r][i] << std::string(widths[i] - rows_[r][i].size(), ' ') << " |";
    }
    output << '\n';
    if (r > 0) continue;
    output << '|';
    for (const std::size_t width : widths) output << std::string(width + 2, '-') << '|';
    output << '\n';
  }
}

void Table::writeCsv(std::ostream& output) const {
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      output << (i > 0 ? "," : "") << support::csvField(row[i]);
    }
    output << '\n';
  }
}

std::string fixed(double value, int digits) {
  if (std::isnan(value)) return {};
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string withInterval(std::size_t successes, std::size_t trials, int digits) {
  if (trials == 0) return {};
  const Bounds bounds = wilsonInterval(successes, trials);
  const double share = static_cast<double>(successes) / static_cast<double>(trials);
  return fixed(share, digits) + " [" + fixed(bounds.low, digits) + ", " +
         fixed(bounds.high, digits) + "]";
}

}  // namespace place_memory::experiments
