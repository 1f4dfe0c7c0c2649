#ifndef PLACE_MEMORY_SUPPORT_TEXT_H
#define PLACE_MEMORY_SUPPORT_TEXT_H

#include <optional>
#include <string>
#include <string_view>

namespace place_memory::support {

/// Offset of the first byte that is no part of a character in UTF-8; nothing where all are.
std::optional<std::size_t> firstNotUtf8(std::string_view text);

/// Whether a text holds line breaks, NUL or other control characters (C0, DEL, C1).
bool hasControls(std::string_view text);

/// The text as it can be shown in a message: what is a control character or no UTF-8 as \xNN.
std::string printable(std::string_view text);

/// Text of a file in UTF-8, without the byte order mark that some editors put first. Throws
/// std::runtime_error where it is UTF-16, or names the first line that is not UTF-8.
std::string decodedText(std::string bytes);

/// Everything in a file. Throws std::runtime_error that names the file and says why it cannot be
/// read.
std::string readWholeFile(const std::string& path);

/// The text without blanks and tabs at either end.
std::string trimmed(std::string_view text);

/// A name of tf as tf2 has it: /base_link and base_link are one frame.
std::string withoutLeadingSlashes(std::string_view name);

/// A decimal number as 12, -.5 or 1e-2, whatever the locale; infinite where it is too large.
/// Nothing where the text is anything else.
std::optional<double> parseDecimal(std::string_view text);

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_TEXT_H
