#ifndef PLACE_MEMORY_NODE_GO_VELOCITY_DRIVER_H
#define PLACE_MEMORY_NODE_GO_VELOCITY_DRIVER_H

#include <optional>

#include "config/parameters.h"
#include "core/drive/leg_driver.h"
#include "node/go/echo_listener.h"
#include "node/go/spot_driver.h"

namespace place_memory::node {

/// Drives by cmd_vel, straight to the spot, by what the sonars hear.
class VelocityDriver : public SpotDriver {
 public:
  /// `echoes` must outlive it.
  VelocityDriver(const config::DriveOptions& options, EchoListener& echoes);
  ~VelocityDriver() override;

  void begin(const core::Pose2d& target, DriveLease::Hold& hold) override;
  void moveTarget(const core::Pose2d& target) override;
  DriveReport update(const RobotFix& fix, std::chrono::nanoseconds now) override;
  void pause() override;
  void stop() override;

 private:
  core::LegDriverOptions options_;
  EchoListener& echoes_;
  DriveLease::Hold* hold_ = nullptr;
  std::optional<core::LegDriver> leg_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_VELOCITY_DRIVER_H
