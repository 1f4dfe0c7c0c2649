#include "node/input/ray_fit.h"

#include <cmath>

namespace place_memory::node {
namespace {

constexpr std::size_t kEnough = 10;
constexpr double kLeastSpread = 0.2;   // standard deviation along the ray [m]
constexpr double kLargestWidth = 0.1;  // across it, as a share of that

}  // namespace

void RayFit::add(const CloudPoint& point) {
  newest_ = point;
  ++count_;
  const double dx = point.x - x_;
  const double dy = point.y - y_;
  x_ += dx / static_cast<double>(count_);
  y_ += dy / static_cast<double>(count_);
  xx_ += dx * (point.x - x_);
  xy_ += dx * (point.y - y_);
  yy_ += dy * (point.y - y_);
}

std::optional<core::Pose2d> RayFit::mount() const {
  if (count_ == 0) return std::nullopt;
  if (const auto line = alongLine()) return line;
  return core::Pose2d{0.0, 0.0, std::atan2(newest_.y, newest_.x)};
}

std::optional<core::Pose2d> RayFit::alongLine() const {
  if (count_ < kEnough) return std::nullopt;
  const double mean = 0.5 * (xx_ + yy_);
  const double apart = std::hypot(0.5 * (xx_ - yy_), xy_);
  const double along = std::sqrt((mean + apart) / static_cast<double>(count_));
  const double across = std::sqrt(std::fmax(mean - apart, 0.0) / static_cast<double>(count_));
  if (along < kLeastSpread || across > kLargestWidth * along) return std::nullopt;
  double yaw = 0.5 * std::atan2(2.0 * xy_, xx_ - yy_);
  if (std::cos(yaw) * x_ + std::sin(yaw) * y_ < 0.0) yaw += core::kPi;
  const double distance = -std::sin(yaw) * x_ + std::cos(yaw) * y_;  // of the line, to its left
  return core::Pose2d{-std::sin(yaw) * distance, std::cos(yaw) * distance, yaw};
}

}  // namespace place_memory::node
