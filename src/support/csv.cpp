#include "support/csv.h"

#include <stdexcept>

#include "support/text.h"

namespace place_memory::support {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Whether `c`, just read, ends a line; of CRLF both are read.
bool endsLine(char c, std::istream& input) {
  if (c == '\r' && input.peek() == '\n') input.get();
  return c == '\n' || c == '\r';
}

void skipComments(std::istream& input, int& line) {
  while (input.peek() == '#') {
    char c = 0;
    while (input.get(c) && !endsLine(c, input)) {
    }
    ++line;
  }
}

/// The field that is being read.
class Field {
 public:
  bool quoted() const { return quoted_; }

  void add(char c) {
    if (quoted_ || !was_quoted_ || !isBlank(c)) text_ += c;
  }

  /// Whether a quote here opens the field.
  bool open() {
    if (was_quoted_ || !trimmed(text_).empty()) return false;
    text_.clear();
    quoted_ = was_quoted_ = true;
    return true;
  }

  void close() { quoted_ = false; }

  std::string finished() const { return was_quoted_ ? text_ : trimmed(text_); }

 private:
  std::string text_;
  bool quoted_ = false;
  bool was_quoted_ = false;
};

}  // namespace

std::optional<std::vector<std::string>> readRecord(std::istream& input, int& line) {
  skipComments(input, line);
  std::vector<std::string> fields;
  Field field;
  bool any = false;
  char c = 0;
  while (input.get(c)) {
    any = true;
    if (field.quoted()) {
      if (c == '\n' || (c == '\r' && input.peek() != '\n')) ++line;
      if (c != '"') {
        field.add(c);
      } else if (input.peek() == '"') {
        field.add(static_cast<char>(input.get()));
      } else {
        field.close();
      }
    } else if (c == ',') {
      fields.push_back(field.finished());
      field = {};
    } else if (endsLine(c, input)) {
      break;
    } else if (c != '"' || !field.open()) {
      field.add(c);
    }
  }
  if (field.quoted()) throw std::runtime_error("a quote is not closed");
  if (!any) return std::nullopt;
  ++line;
  fields.push_back(field.finished());
  return fields;
}

std::string csvField(const std::string& text) {
  const bool is_plain = text.find_first_of(",\"\r\n") == std::string::npos &&
                        trimmed(text) == text && text.rfind('#', 0) != 0;
  if (is_plain) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace place_memory::support
