#ifndef PLACE_MEMORY_EXPERIMENTS_TABLE_H
#define PLACE_MEMORY_EXPERIMENTS_TABLE_H

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace place_memory::experiments {

/// Rows of texts under a header.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}

  /// As many cells as the header has.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  /// Padded, so that it reads as plain text too.
  void writeMarkdown(std::ostream& output) const;
  void writeCsv(std::ostream& output) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// With so many digits behind the point; empty for NaN.
std::string fixed(double value, int digits);

/// A share of the trials and its 95 % interval; empty for no trials.
std::string withInterval(std::size_t successes, std::size_t trials, int digits);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_TABLE_H
