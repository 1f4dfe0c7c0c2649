#include "core/store/packed_readings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/store/packed_bytes.h"

namespace place_memory::core {
namespace {

using SpecNumber = std::uint16_t;

constexpr std::size_t kReadingBytes = 4 * sizeof(float) + sizeof(SpecNumber);

std::vector<SonarSpec> specsOf(const std::vector<SonarReading>& readings) {
  std::vector<SonarSpec> specs;
  for (const SonarReading& reading : readings) {
    if (std::find(specs.begin(), specs.end(), reading.spec) == specs.end()) {
      specs.push_back(reading.spec);
    }
  }
  return specs;
}

bool isSound(const SonarSpec& spec) {
  return spec.field_of_view > 0.0 && spec.min_range >= 0.0 && spec.max_range >= spec.min_range &&
         std::isfinite(spec.field_of_view) && std::isfinite(spec.max_range);
}

SonarReading takeReading(ByteUnpacker& bytes, const std::vector<SonarSpec>& specs, bool& sound) {
  SonarReading reading;
  reading.sensor_pose.x = static_cast<double>(bytes.take<float>());
  reading.sensor_pose.y = static_cast<double>(bytes.take<float>());
  reading.sensor_pose.yaw = static_cast<double>(bytes.take<float>());
  reading.range = static_cast<double>(bytes.take<float>());
  const auto number = bytes.take<SpecNumber>();
  sound = sound && number < specs.size() && reading.sensor_pose.isFinite() && reading.range >= 0.0;
  if (!sound) return reading;
  reading.spec = specs[number];
  if (std::isfinite(reading.range)) {  // single precision may have put it past the limit
    reading.range = std::clamp(reading.range, reading.spec.min_range, reading.spec.max_range);
  }
  return reading;
}

}  // namespace

std::vector<unsigned char> packReadings(const std::vector<SonarReading>& readings) {
  const std::vector<SonarSpec> specs = specsOf(readings);
  BytePacker bytes;
  bytes.add(static_cast<SpecNumber>(specs.size()));
  for (const SonarSpec& spec : specs) {
    bytes.add(spec.field_of_view).add(spec.min_range).add(spec.max_range);
  }
  for (const SonarReading& reading : readings) {
    bytes.add(static_cast<float>(reading.sensor_pose.x))
        .add(static_cast<float>(reading.sensor_pose.y))
        .add(static_cast<float>(reading.sensor_pose.yaw))
        .add(static_cast<float>(reading.range))
        .add(static_cast<SpecNumber>(std::find(specs.begin(), specs.end(), reading.spec) -
                                     specs.begin()));
  }
  return bytes.bytes();
}

std::optional<std::vector<SonarReading>> unpackReadings(const void* bytes, std::size_t size) {
  ByteUnpacker unpacker(bytes, size);
  std::vector<SonarSpec> specs(unpacker.take<SpecNumber>());
  bool sound = true;
  for (SonarSpec& spec : specs) {
    spec.field_of_view = unpacker.take<double>();
    spec.min_range = unpacker.take<double>();
    spec.max_range = unpacker.take<double>();
    sound = sound && isSound(spec);
  }
  if (!sound || !unpacker.good() || unpacker.left() % kReadingBytes != 0) return std::nullopt;
  std::vector<SonarReading> readings;
  readings.reserve(unpacker.left() / kReadingBytes);
  while (sound && unpacker.left() > 0) {
    readings.push_back(takeReading(unpacker, specs, sound));
  }
  if (!sound) return std::nullopt;
  return readings;
}

}  // namespace place_memory::core
