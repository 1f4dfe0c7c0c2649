#ifndef PLACE_MEMORY_CONFIG_ANGLE_EXPRESSION_H
#define PLACE_MEMORY_CONFIG_ANGLE_EXPRESSION_H

#include <optional>
#include <string>

namespace place_memory::config {

/// The value [rad] of deg(2), rad(pi/90), or of a sum, product or power with pi, as pi/90: what
/// rosparam computes. Nothing where the text is anything else.
std::optional<double> angleExpression(const std::string& text);

/// `text` in degrees, a decimal number [rad].
std::optional<double> degrees(const std::string& text);

/// Decimal numbers and pi, with + - * / ** and brackets.
std::optional<double> arithmetic(const std::string& text);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_ANGLE_EXPRESSION_H
