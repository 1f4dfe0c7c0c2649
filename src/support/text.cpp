#include "support/text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace place_memory::support {
namespace {

struct Character {
  std::size_t bytes = 0;  ///< 0: no character
  std::uint32_t code = 0;
};

// RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF.
Character decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t lead = byte(at);
  if (lead < 0x80) return {1, lead};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + bytes > text.size()) return {};
  std::uint32_t code = lead & (0x7fU >> bytes);
  for (std::size_t i = at + 1; i < at + bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return {};
    code = code << 6U | (byte(i) & 0x3fU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  if (code < kLeast[bytes] || code > 0x10ffff || is_surrogate) return {};
  return {bytes, code};
}

bool isControl(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

bool startsWith(const std::string& text, const char* bytes) { return text.rfind(bytes, 0) == 0; }

std::string digits(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return std::string(text.substr(begin, at - begin));
}

bool isDecimal(std::string_view text) {
  std::size_t at = 0;
  const auto skip = [&](const char* any_of) {
    const bool found = at < text.size() && std::strchr(any_of, text[at]) != nullptr;
    if (found) ++at;
    return found;
  };
  skip("+-");
  std::size_t count = digits(text, at).size();
  if (skip(".")) count += digits(text, at).size();
  if (count == 0) return false;
  if (skip("eE")) {
    skip("+-");
    if (digits(text, at).empty()) return false;
  }
  return at == text.size();
}

}  // namespace

std::optional<std::size_t> firstNotUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character character = decode(text, at);
    if (character.bytes == 0) return at;
    at += character.bytes;
  }
  return std::nullopt;
}

bool hasControls(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character character = decode(text, at);
    if (character.bytes != 0 && isControl(character.code)) return true;
    at += std::max<std::size_t>(character.bytes, 1);
  }
  return false;
}

std::string printable(std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const Character character = decode(text, at);
    if (character.bytes != 0 && !isControl(character.code)) {
      shown += text.substr(at, character.bytes);
      at += character.bytes;
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[at++]);
    shown += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 0xfU]};
  }
  return shown;
}

std::string decodedText(std::string bytes) {
  const std::string head = bytes.substr(0, 64);
  // Without its mark UTF-16 shows by the zeros beside each letter.
  if (startsWith(bytes, "\xff\xfe") || startsWith(bytes, "\xfe\xff") ||
      std::count(head.begin(), head.end(), '\0') > static_cast<std::ptrdiff_t>(head.size() / 4)) {
    throw std::runtime_error("is UTF-16 or binary, not text in UTF-8; save the file as UTF-8");
  }
  if (startsWith(bytes, "\xef\xbb\xbf")) bytes.erase(0, 3);
  if (const auto at = firstNotUtf8(bytes)) {
    const auto lines =
        std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(*at), '\n');
    throw std::runtime_error("line " + std::to_string(lines + 1) +
                             ": is not UTF-8 (Latin-1, perhaps); save the file as UTF-8");
  }
  return bytes;
}

std::string readWholeFile(const std::string& path) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) throw std::runtime_error(path + ": is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  if (file) bytes.assign(std::istreambuf_iterator<char>(file), {});
  if (!file || file.bad()) {
    const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw std::runtime_error(path + ": cannot be read" + reason);
  }
  return bytes;
}

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t") - begin + 1));
}

std::string withoutLeadingSlashes(std::string_view name) {
  return std::string(name.substr(std::min(name.find_first_not_of('/'), name.size())));
}

std::optional<double> parseDecimal(std::string_view text) {
  if (!isDecimal(text)) return std::nullopt;
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number)) {
    return std::copysign(std::numeric_limits<double>::infinity(), number);
  }
  return number;
}

}  // namespace place_memory::support
