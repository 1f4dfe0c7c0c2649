#ifndef PLACE_MEMORY_NODE_BASE_COLORS_H
#define PLACE_MEMORY_NODE_BASE_COLORS_H

#include <std_msgs/ColorRGBA.h>

namespace place_memory::node {

/// One colour for each thing in rviz, after the palette of Okabe and Ito, which colour-blind people
/// tell apart, and readable on light and on dark. The building is grey (rviz draws it).
struct Rgb {
  float red, green, blue;
};

constexpr Rgb kScanColor{0.84F, 0.37F, 0.0F};      ///< vermilion: what is sensed now
constexpr Rgb kRecalledColor{0.0F, 0.62F, 0.45F};  ///< green: the recalled place
constexpr Rgb kPlaceColor{0.2F, 0.5F, 0.9F};       ///< blue: places, links and their labels
constexpr Rgb kLikelyColor{0.8F, 0.25F, 0.65F};    ///< purple: where the robot may be

inline std_msgs::ColorRGBA toColor(const Rgb& rgb, float alpha) {
  std_msgs::ColorRGBA color;
  color.r = rgb.red;
  color.g = rgb.green;
  color.b = rgb.blue;
  color.a = alpha;
  return color;
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_COLORS_H
