#include <ros/time.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <memory>

#include "fuzz/targets.h"
#include "node/input/message_intake.h"
#include "node/input/raw_message.h"
#include "node/input/transform_filter.h"

namespace place_memory::fuzz {
namespace {

using namespace node;  // NOLINT(google-build-using-namespace): this is of nothing else

constexpr std::chrono::nanoseconds kNow = std::chrono::seconds(1000);

template <class Content>
RawMessage rawOf(const std::uint8_t* bytes, std::size_t size) {
  RawMessage message;
  message.describe(ros::message_traits::DataType<Content>::value(),
                   ros::message_traits::MD5Sum<Content>::value());
  message.fill(bytes, static_cast<std::uint32_t>(size));
  return message;
}

void check(const AdaptedReading& reading) {
  require(reading.measurement.sensor <= SensorRegistry::kMaxSensors, "more sensors than there may");
  if (reading.reject) return;
  const core::Measurement& m = reading.measurement;
  require(m.frame_from_sensor.isFinite(), "a sensor's pose is not finite");
  require(m.spec.field_of_view > 0.0 && m.spec.field_of_view <= core::kPi, "no field of view");
  require(m.spec.min_range >= 0.0 && m.spec.max_range >= m.spec.min_range, "no range of ranges");
  require(std::isfinite(m.spec.max_range), "an infinite range of ranges");
  require(m.range >= 0.0, "a range below 0, or none");
  require(std::isinf(m.range) || m.range <= m.spec.max_range, "a range beyond its range");
  require(!m.frame.empty(), "a reading without a frame");
}

/// Everything that hears messages, as in the node.
class Listener {
 public:
  Listener() {
    parameters_.sonar_topics = {"/sonar", "/other"};
    parameters_.heading_topic = "/heading";
    parameters_.odom_topic = "/odom";
    intake_ = std::make_unique<MessageIntake>(
        parameters_, [](const std::string& name) { return name; }, registry_);
  }

  // The first byte says of which type the message is.
  void hear(const std::uint8_t* bytes, std::size_t size) {
    const std::uint8_t type = bytes[0];
    ++bytes;
    --size;
    const char* const sonar = type % 2 == 0 ? "/sonar" : "/other";
    switch (type / 2 % 9) {
      case 0:
        return take(sonar, rawOf<sensor_msgs::Range>(bytes, size));
      case 1:
        return take(sonar, rawOf<sensor_msgs::PointCloud>(bytes, size));
      case 2:
        return take(sonar, rawOf<sensor_msgs::PointCloud2>(bytes, size));
      case 3:
        return take(sonar, rawOf<sensor_msgs::LaserScan>(bytes, size));
      case 4:
        return take("/heading", rawOf<sensor_msgs::Imu>(bytes, size));
      case 5:
        return take("/heading", rawOf<sensor_msgs::MagneticField>(bytes, size));
      case 6:
        return take("/heading", rawOf<std_msgs::Float64>(bytes, size));
      case 7:
        return take("/odom", rawOf<nav_msgs::Odometry>(bytes, size));
      default:
        return transform(rawOf<tf2_msgs::TFMessage>(bytes, size), type % 2 == 0);
    }
  }

 private:
  void take(const char* topic, const RawMessage& message) {
    const Taken taken = intake_->take(topic, readMessage(message), kNow, buffer_);
    for (const AdaptedReading& reading : taken.readings) check(reading);
    for (const CheckedHeading& heading : taken.headings) {
      require(heading.problem || std::isfinite(heading.yaw), "a heading is not finite");
    }
    for (const auto& odometry : taken.transforms) addTransform(odometry, false, kNow, buffer_);
    intake_->wrongTypes();
  }

  void transform(const RawMessage& message, bool is_static) {
    boost::shared_ptr<tf2_msgs::TFMessage> transforms;
    try {
      transforms = message.instantiate<tf2_msgs::TFMessage>();
    } catch (const std::exception&) {  // roscpp's own, before anything of this package is called
      return;
    }
    for (const auto& one : transforms->transforms) addTransform(one, is_static, kNow, buffer_);
  }

  config::Parameters parameters_;
  SensorRegistry registry_;
  tf2::BufferCore buffer_;
  std::unique_ptr<MessageIntake> intake_;
};

}  // namespace

// Messages in a row, the size of each in two bytes before it.
void runMessages(const std::uint8_t* bytes, std::size_t size) {
  Listener listener;
  while (size > 3) {
    std::size_t length = bytes[0] | static_cast<std::size_t>(bytes[1]) << 8U;
    bytes += 2;
    size -= 2;
    length = std::min(std::max<std::size_t>(length, 1), size);
    listener.hear(bytes, length);
    bytes += length;
    size -= length;
  }
}

}  // namespace place_memory::fuzz
