#include "config/yaml_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <regex>
#include <sstream>

#include "config/angle_expression.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

// Tags of yaml-cpp: of a scalar in quotes or a block, and of one without a tag.
constexpr char kQuoted[] = "!";
constexpr char kPlain[] = "?";

// Of YAML 1.1 (http://yaml.org/type), which PyYAML goes by.
constexpr char kTags[] = "tag:yaml.org,2002:";
constexpr char kDegrees[] = "!degrees";
constexpr char kRadians[] = "!radians";

// No number or date is longer, and a regular expression takes stack by the length of the text.
constexpr std::size_t kLongest = 80;

bool matches(const std::string& text, const std::regex& pattern) {
  return text.size() <= kLongest && std::regex_match(text, pattern);
}

bool isInteger(const std::string& text) {
  static const std::regex kPattern(
      "[-+]?0b[01_]+|[-+]?0[0-7_]+|[-+]?(0|[1-9][0-9_]*)|[-+]?0x[0-9a-fA-F_]+|"
      "[-+]?[1-9][0-9_]*(:[0-5]?[0-9])+");
  return matches(text, kPattern);
}

bool isReal(const std::string& text) {
  static const std::regex kPattern(
      R"([-+]?[0-9][0-9_]*\.[0-9_]*([eE][-+][0-9]+)?|\.[0-9][0-9_]*([eE][-+][0-9]+)?|)"
      R"([-+]?[0-9][0-9_]*(:[0-5]?[0-9])+\.[0-9_]*|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN))");
  return matches(text, kPattern);
}

bool isDate(const std::string& text) {
  static const std::regex kPattern(
      R"([0-9]{4}-[0-9]{2}-[0-9]{2}|)"
      R"([0-9]{4}-[0-9]{1,2}-[0-9]{1,2}([Tt]|[ \t]+)[0-9]{1,2}:[0-9]{2}:[0-9]{2}(\.[0-9]*)?)"
      R"(([ \t]*(Z|[-+][0-9]{1,2}(:[0-9]{2})?))?)");
  return matches(text, kPattern);
}

bool isAngle(const std::string& text) {
  static const std::regex kPattern(R"((deg|rad)\([^)]*\))");
  return matches(text, kPattern);
}

std::optional<bool> readFlag(const std::string& text) {
  for (const char* word : {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}) {
    if (text == word) return true;
  }
  for (const char* word : {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}) {
    if (text == word) return false;
  }
  return std::nullopt;
}

bool isNothing(const std::string& text) {
  return text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL";
}

ValueKind kindOfPlain(const std::string& text) {
  if (isNothing(text)) return ValueKind::kNothing;
  if (readFlag(text)) return ValueKind::kFlag;
  if (isInteger(text) || isReal(text) || isAngle(text)) return ValueKind::kNumber;
  return isDate(text) ? ValueKind::kDate : ValueKind::kText;
}

std::string withoutUnderscores(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

double digitsOfBase(const std::string& digits, int base) {
  double value = 0.0;
  for (const char c : digits) {
    const int digit = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
    value = value * base + digit;
  }
  return value;
}

// Hours, minutes and seconds, as 1:30.5.
double sexagesimal(const std::string& text) {
  double value = 0.0;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ':');) {
    value = value * 60.0 + support::parseDecimal(part).value_or(0.0);
  }
  return value;
}

// Of what isInteger() or isReal() found.
double evaluate(std::string text) {
  text = withoutUnderscores(text);
  const double sign = text.front() == '-' ? -1.0 : 1.0;
  if (text.front() == '-' || text.front() == '+') text.erase(0, 1);
  if (text.rfind("0b", 0) == 0) return sign * digitsOfBase(text.substr(2), 2);
  if (text.rfind("0x", 0) == 0) return sign * digitsOfBase(text.substr(2), 16);
  if (text.find(':') != std::string::npos) return sign * sexagesimal(text);
  const bool is_real = text.find('.') != std::string::npos;
  if (is_real && (text[1] == 'i' || text[1] == 'I')) {
    return sign * std::numeric_limits<double>::infinity();
  }
  if (is_real && (text[1] == 'n' || text[1] == 'N')) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!is_real && text.front() == '0') return sign * digitsOfBase(text, 8);
  return sign * support::parseDecimal(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

// What is a number to everybody but YAML 1.1, which knows no exponent without point and sign.
std::optional<double> meantNumber(const std::string& text) {
  static const std::regex kPattern(
      R"([-+]?([0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+|[-+]\.[0-9]+)");
  if (matches(text, kPattern)) return support::parseDecimal(text);
  return angleExpression(text);
}

std::string tagOf(const YAML::Node& node) {
  const std::string& tag = node.Tag();
  const std::size_t length = sizeof(kTags) - 1;
  return tag.rfind(kTags, 0) == 0 ? tag.substr(length) : tag;
}

}  // namespace

ValueKind kindOf(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return ValueKind::kNothing;
  if (node.IsMap()) return ValueKind::kTable;
  if (node.IsSequence()) return ValueKind::kList;
  const std::string tag = tagOf(node);
  if (tag.empty() || tag == kPlain) return kindOfPlain(node.Scalar());
  if (tag == kQuoted || tag == "str") return ValueKind::kText;
  if (tag == "int" || tag == "float" || tag == kDegrees || tag == kRadians) {
    return ValueKind::kNumber;
  }
  if (tag == "bool") return ValueKind::kFlag;
  if (tag == "null") return ValueKind::kNothing;
  if (tag == "timestamp") return ValueKind::kDate;
  return tag == "binary" ? ValueKind::kBinary : ValueKind::kForeign;
}

std::optional<double> numberOf(const YAML::Node& node) {
  const ValueKind kind = kindOf(node);
  if (kind != ValueKind::kNumber && kind != ValueKind::kText) return std::nullopt;
  const std::string& text = node.Scalar();
  if (kind == ValueKind::kText) return meantNumber(text);
  if (tagOf(node) == kDegrees) return isAngle(text) ? angleExpression(text) : degrees(text);
  if (tagOf(node) == kRadians) return isAngle(text) ? angleExpression(text) : arithmetic(text);
  if (isInteger(text) || isReal(text)) return evaluate(text);
  return meantNumber(text);
}

std::optional<bool> flagOf(const YAML::Node& node) {
  if (kindOf(node) != ValueKind::kFlag) return std::nullopt;
  return readFlag(node.Scalar());
}

std::optional<core::Pose2d> poseOf(const YAML::Node& node) {
  constexpr double kLargest = 100.0;
  if (!node.IsSequence() || node.size() != 3) return std::nullopt;
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<double> number = numberOf(node[i]);
    // Written so that NaN fails.
    if (!number || !(std::abs(*number) <= kLargest)) return std::nullopt;
    numbers[i] = *number;
  }
  return core::Pose2d{numbers[0], numbers[1], numbers[2]};
}

std::string shown(const YAML::Node& node) {
  switch (kindOf(node)) {
    case ValueKind::kNothing:
      return "nothing";
    case ValueKind::kList:
      return "a list";
    case ValueKind::kTable:
      return "a table";
    case ValueKind::kBinary:
      return "binary data";
    case ValueKind::kForeign:
      return "a value tagged " + support::printable(node.Tag());
    case ValueKind::kDate:
      return "the date '" + support::printable(node.Scalar()) + "'";
    default:
      return "'" + support::printable(node.Scalar()) + "'";
  }
}

}  // namespace place_memory::config
