#include "core/mapping/mapper.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/store/packed_bytes.h"
#include "fuzz/targets.h"

namespace place_memory::fuzz {
namespace {

using core::Pose2d;

// As what feeds a mapper bounds it: see kFarthest of node/input/transform_filter.h.
constexpr double kFarthest = 1e8;

void checkAll(const core::KeptMap& map) {
  for (const core::ScanNode& node : map.nodes) {
    require(node.pose.isFinite(), "a scan's pose that is not finite");
    require(node.place == core::kNoPlace || node.readings != nullptr, "a place without readings");
    require(node.place < map.next_place, "an id that will be given again");
  }
  for (const core::Tie& tie : map.ties) {
    require(tie.node < map.nodes.size() && tie.place < map.nodes.size(), "a tie to nothing");
    require(tie.relative.isFinite() && tie.information.allFinite(), "a tie that is not finite");
  }
}

/// Drives a mapper along, each deed in some bytes.
class Driver {
 public:
  Driver() : mapper_(std::make_unique<core::Mapper>(options_)) {}

  void run(core::ByteUnpacker& bytes) {
    while (bytes.left() > 0) {
      act(bytes);
      for (const core::ScanDecision& decision : mapper_->takeDecisions()) {
        require(decision.lost >= 0.0 && decision.lost <= 1.0, "no probability");
        require(decision.place_from_base.isFinite(), "a pose that is not finite");
      }
      mapper_->takeEvents();
    }
    const auto pose = mapper_->mapFromOdom();
    require(!pose || pose->isFinite(), "a correction that is not finite");
    const core::BeliefSummary belief = mapper_->belief();
    require(belief.off_map >= 0.0 && belief.off_map <= 1.0 + 1e-9, "no probability");
    checkAll(mapper_->map());
    takeUp();
  }

 private:
  void act(core::ByteUnpacker& bytes) {
    const auto deed = bytes.take<std::uint8_t>();
    switch (deed < 128 ? 0 : deed % 12) {
      case 1:
        return mapper_->addHeading(stamp_, 0.025 * bytes.take<std::int8_t>());
      case 2:
        return mapper_->beginSession();
      case 3:
        return mapper_->setPose(anywhere(bytes));
      case 4:
        return mapper_->addStanding(stamp_, odom_, readings(16, bytes));
      case 5:
        return mapper_->adopt(adopted(), stamp_);
      case 6:
        return mapper_->forget(bytes.take<std::uint8_t>());
      case 7:
        return mapper_->setNamed(bytes.take<std::uint8_t>());
      case 8:
        return mapper_->setMode(bytes.take<std::uint8_t>() % 2 == 0 ? core::MapperMode::kMap
                                                                    : core::MapperMode::kLocalize);
      case 9:
        odom_ = anywhere(bytes);
        return mapper_->addOdometry(stamp_, odom_);
      case 10:
        return takeUp();
      default:
        return step(bytes);
    }
  }

  // Some centimetres on, with what a ring of sonars hears there.
  void step(core::ByteUnpacker& bytes) {
    stamp_ += std::chrono::milliseconds(100);
    const auto on = bytes.take<std::int8_t>();
    const auto turned = bytes.take<std::int8_t>();
    odom_ = odom_ * Pose2d{0.004 * on, 0.0, 0.008 * turned};
    mapper_->addOdometry(stamp_, odom_);
    for (const core::SonarReading& reading : readings(8, bytes)) {
      mapper_->addReading(stamp_, odom_, reading);
    }
  }

  static std::vector<core::SonarReading> readings(int count, core::ByteUnpacker& bytes) {
    std::vector<core::SonarReading> heard;
    for (int i = 0; i < count; ++i) {
      const double yaw = core::wrapAngle(2.0 * core::kPi * i / count);
      const Pose2d sensor{0.2 * std::cos(yaw), 0.2 * std::sin(yaw), yaw};
      heard.push_back({sensor, {0.4, 0.1, 5.0}, 0.02 * bytes.take<std::uint8_t>()});
    }
    return heard;
  }

  static Pose2d anywhere(core::ByteUnpacker& bytes) {
    Pose2d pose;
    for (double* number : {&pose.x, &pose.y, &pose.yaw}) {
      *number = bytes.take<double>();
      if (!std::isfinite(*number) || std::abs(*number) > kFarthest) *number = 0.0;
    }
    pose.yaw = core::wrapAngle(pose.yaw);
    return pose;
  }

  core::PlaceId adopted() const { return mapper_->map().next_place; }

  // As after a restart of the node.
  void takeUp() {
    const core::KeptMap map = mapper_->map();
    mapper_ = std::make_unique<core::Mapper>(options_);
    if (!map.nodes.empty()) mapper_->restore(map);
  }

  const core::MapperOptions options_;
  std::unique_ptr<core::Mapper> mapper_;
  std::chrono::nanoseconds stamp_ = std::chrono::seconds(1000);
  Pose2d odom_;
};

}  // namespace

void runMapper(const std::uint8_t* bytes, std::size_t size) {
  core::ByteUnpacker input(bytes, std::min<std::size_t>(size, 20000));
  Driver().run(input);
}

}  // namespace place_memory::fuzz
