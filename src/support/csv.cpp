#include "support/csv.h"

#include <stdexcept>

namespace place_memory::support {

std::optional<std::vector<std::string>> readRecord(std::istream& input, int& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  bool any = false;
  char c = 0;
  while (input.get(c)) {
    any = true;
    if (c == '\n') ++line;
    if (quoted) {
      if (c != '"') {
        fields.back() += c;
      } else if (input.peek() == '"') {
        fields.back() += static_cast<char>(input.get());
      } else {
        quoted = false;
      }
    } else if (c == '"' && fields.back().empty()) {
      quoted = true;
    } else if (c == ',') {
      fields.emplace_back();
    } else if (c == '\n') {
      return fields;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  if (quoted) throw std::runtime_error("a quote is not closed");
  if (!any) return std::nullopt;
  ++line;
  return fields;
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace place_memory::support
