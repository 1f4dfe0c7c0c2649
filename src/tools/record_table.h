#ifndef PLACE_MEMORY_TOOLS_RECORD_TABLE_H
#define PLACE_MEMORY_TOOLS_RECORD_TABLE_H

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace place_memory::tools {

/// What stands in a table: text, a whole number, a number with so many decimals, or yes and no.
struct Decimal {
  double number = 0.0;
  int decimals = 3;
};
using Cell = std::variant<std::string, std::int64_t, Decimal, bool>;

/// Records of one kind, for people and for programs.
class RecordTable {
 public:
  /// `names` are those of the columns, and of the fields in JSON.
  explicit RecordTable(std::vector<std::string> names) : names_(std::move(names)) {}

  /// A cell for each column.
  void add(std::vector<Cell> row) { rows_.push_back(std::move(row)); }
  std::size_t size() const { return rows_.size(); }

  /// In columns under their names, numbers to the right; nothing where there is no record.
  void print(std::ostream& out) const;
  /// An array with an object for each record.
  void printJson(std::ostream& out) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<Cell>> rows_;
};

/// The text as JSON has it, in quotes; what is not UTF-8 as \xNN.
std::string jsonText(const std::string& text);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_RECORD_TABLE_H
