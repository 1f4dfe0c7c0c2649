#ifndef PLACE_MEMORY_SUPPORT_CSV_H
#define PLACE_MEMORY_SUPPORT_CSV_H

#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace place_memory::support {

/// The next record of comma-separated values (RFC 4180), nothing at the end. Lines end with LF,
/// CRLF or CR; blanks around a field count only in quotes; lines that begin with # are left out.
/// `line` is raised by the lines that were read. Throws std::runtime_error where a quote is not
/// closed.
std::optional<std::vector<std::string>> readRecord(std::istream& input, int& line);

/// A field, in quotes where it has to be.
std::string csvField(const std::string& text);

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_CSV_H
