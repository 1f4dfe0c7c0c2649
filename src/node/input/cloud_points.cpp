#include "node/input/cloud_points.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace place_memory::node {
namespace {

using sensor_msgs::PointField;

CloudPoints problem(const std::string& text) {
  CloudPoints none;
  none.problem = text;
  return none;
}

// Empty: a ring may have so many.
std::string checkCount(std::uint64_t count) {
  if (count == 0) return "its cloud holds no points: are the sonars switched on?";
  if (count <= kMostCloudPoints) return {};
  return "its cloud holds " + std::to_string(count) + " points, a ring of sonars " +
         std::to_string(kMostCloudPoints) + " at the most: is it the cloud of another sensor?";
}

std::size_t sizeOf(const PointField& field) {
  if (field.datatype == PointField::FLOAT32) return sizeof(float);
  if (field.datatype == PointField::FLOAT64) return sizeof(double);
  return 0;
}

double numberAt(const std::uint8_t* at, const PointField& field) {
  if (field.datatype == PointField::FLOAT64) {
    double number = 0.0;
    std::memcpy(&number, at, sizeof(number));
    return number;
  }
  float number = 0.0F;
  std::memcpy(&number, at, sizeof(number));
  return number;
}

// Empty: the field can be read from each point.
std::string checkField(const sensor_msgs::PointCloud2& cloud, const std::string& name,
                       const PointField*& found) {
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&](const PointField& other) { return other.name == name; });
  if (field == cloud.fields.end()) return "its cloud has no field " + name;
  found = &*field;
  const std::size_t size = sizeOf(*field);
  if (size == 0) return "the field " + name + " of its cloud is neither FLOAT32 nor FLOAT64";
  if (std::uint64_t{field->offset} + size > cloud.point_step) {
    return "the field " + name + " of its cloud lies beyond point_step";
  }
  return {};
}

}  // namespace

CloudPoints pointsOf(const sensor_msgs::PointCloud& cloud) {
  const std::string wrong = checkCount(cloud.points.size());
  if (!wrong.empty()) return problem(wrong);
  CloudPoints found;
  for (const geometry_msgs::Point32& point : cloud.points) {
    found.points.push_back({point.x, point.y});
  }
  return found;
}

CloudPoints pointsOf(const sensor_msgs::PointCloud2& cloud) {
  const std::string wrong = checkCount(std::uint64_t{cloud.width} * cloud.height);
  if (!wrong.empty()) return problem(wrong);
  const PointField* x = nullptr;
  const PointField* y = nullptr;
  for (const std::string& text : {checkField(cloud, "x", x), checkField(cloud, "y", y)}) {
    if (!text.empty()) return problem(text);
  }
  if (cloud.is_bigendian != 0) return problem("its cloud is big-endian, which is not read");
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if ((cloud.height > 1 && cloud.row_step < row) ||
      std::uint64_t{cloud.row_step} * (cloud.height - 1) + row > cloud.data.size()) {
    return problem("its cloud has less data than width, height, point_step and row_step say");
  }
  CloudPoints found;
  for (std::uint32_t v = 0; v < cloud.height; ++v) {
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      const std::uint8_t* const point =
          cloud.data.data() + std::size_t{cloud.row_step} * v + std::size_t{cloud.point_step} * u;
      found.points.push_back({numberAt(point + x->offset, *x), numberAt(point + y->offset, *y)});
    }
  }
  return found;
}

}  // namespace place_memory::node
