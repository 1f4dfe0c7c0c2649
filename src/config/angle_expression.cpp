#include "config/angle_expression.h"

#include <cctype>
#include <cmath>
#include <string_view>

#include "place_memory/core/pose2d.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

// Longer ones would only nest deeply.
constexpr std::size_t kLongest = 80;

/// Reads an expression from left to right; what cannot be read sets `wrong`.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<double> all() {
    const double value = sum();
    skipBlanks();
    if (wrong_ || at_ != text_.size()) return std::nullopt;
    return value;
  }

 private:
  double sum() {
    double value = product();
    while (!wrong_) {
      if (take("+")) {
        value += product();
      } else if (take("-")) {
        value -= product();
      } else {
        break;
      }
    }
    return value;
  }

  double product() {
    double value = signedPower();
    while (!wrong_) {
      if (take("*")) {
        value *= signedPower();
      } else if (take("/")) {
        value /= signedPower();
      } else {
        break;
      }
    }
    return value;
  }

  // A power binds closer than the sign before it: -2**2 is -4.
  double signedPower() {
    if (take("-")) return -signedPower();
    if (take("+")) return signedPower();
    const double base = atom();
    return take("**") ? std::pow(base, signedPower()) : base;
  }

  double atom() {
    if (take("pi")) return core::kPi;
    if (take("(")) {
      const double value = sum();
      if (!take(")")) wrong_ = true;
      return value;
    }
    skipBlanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && isPartOfNumber(begin)) ++at_;
    const auto number = support::parseDecimal(text_.substr(begin, at_ - begin));
    if (!number) wrong_ = true;
    return number.value_or(0.0);
  }

  bool isPartOfNumber(std::size_t begin) const {
    const char c = text_[at_];
    const bool after_e = at_ > begin && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == 'e' || c == 'E' ||
           (after_e && (c == '-' || c == '+'));
  }

  // A star alone is no half of a power.
  bool take(std::string_view token) {
    skipBlanks();
    if (text_.substr(at_, token.size()) != token) return false;
    if (token == "*" && text_.substr(at_, 2) == "**") return false;
    at_ += token.size();
    return true;
  }

  void skipBlanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool wrong_ = false;
};

std::optional<std::string> inside(const std::string& text, const std::string& function) {
  const std::string begin = function + "(";
  if (text.rfind(begin, 0) != 0 || text.back() != ')') return std::nullopt;
  return text.substr(begin.size(), text.size() - begin.size() - 1);
}

}  // namespace

std::optional<double> degrees(const std::string& text) {
  const auto number = support::parseDecimal(support::trimmed(text));
  if (!number) return std::nullopt;
  return *number * core::kPi / 180.0;
}

std::optional<double> arithmetic(const std::string& text) {
  if (text.size() > kLongest) return std::nullopt;
  return Reader(text).all();
}

std::optional<double> angleExpression(const std::string& text) {
  if (const auto angle = inside(text, "deg")) return degrees(*angle);
  if (const auto angle = inside(text, "rad")) return arithmetic(*angle);
  return text.find("pi") == std::string::npos ? std::nullopt : arithmetic(text);
}

}  // namespace place_memory::config
