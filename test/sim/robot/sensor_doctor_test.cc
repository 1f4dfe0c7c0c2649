#include "core/recognize/sensor_doctor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "sim/building/building_generator.h"
#include "sim/robot/random_robot.h"
#include "sim/scene/scene.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/random.h"

namespace place_memory::sim {
namespace {

using core::SensorDiagnosis;
using core::SensorFault;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kDegree = core::kPi / 180.0;
constexpr int kScans = 24;

// What is wrong with one sensor of a robot.
struct Fault {
  SensorFault kind = SensorFault::kNone;
  std::uint32_t sensor = 0;
  std::uint32_t other = 0;  // with kCrosstalk
  double yaw = 0.0;         // with kMountedOff: of the axis, more than is known [rad]
};

// A ring of eight sensors or more, each looking where the others do not.
SimulatedRobot ringRobot(std::uint64_t seed) {
  for (std::uint64_t s = 1000 * seed;; ++s) {
    const SimulatedRobot robot = randomRobot(s);
    if (robot.ring.count >= 8 && robot.ring.count * robot.ring.spacing > 6.0 &&
        robot.ring.spec.max_range > 3.0) {
      return robot;
    }
  }
}

class Robot {
 public:
  Robot(const World& world, const SimulatedRobot& robot, const Fault& fault, std::uint64_t seed)
      : scene_(world), robot_(robot), fault_(fault), rng_(seed) {}

  void mend() { fault_ = {}; }
  void breakDown(const Fault& fault) { fault_ = fault; }

  // The readings and their sensors alone, in the base's frame at the beginning.
  core::Scan scan(const core::Pose2d& base) {
    core::Scan scan;
    std::vector<double> ranges;
    for (int set = 0; set < robot_.sweep.headings; ++set) {
      const core::Pose2d turned = core::Pose2d{0.0, 0.0, set * robot_.sweep.step};
      ranges.clear();
      for (int i = 0; i < robot_.ring.count; ++i) ranges.push_back(ping(base * turned, i));
      hearOthers(ranges);
      for (std::uint32_t sensor = 0; sensor < ranges.size(); ++sensor) {
        const double range = ranges[sensor];
        if (std::isinf(range) && range < 0.0) continue;
        if (fault_.kind == SensorFault::kDead && sensor == fault_.sensor) continue;
        const core::Pose2d mount = sensorPose(robot_.ring, static_cast<int>(sensor));
        scan.readings.push_back({turned * mount, robot_.ring.spec, range});
        scan.sensors.push_back(sensor);
      }
    }
    return scan;
  }

 private:
  double ping(const core::Pose2d& base, int index) {
    core::Pose2d sensor = sensorPose(robot_.ring, index);
    if (static_cast<std::uint32_t>(index) != fault_.sensor) {
      return pingSonar(scene_, {}, base * sensor, robot_.ring.spec, robot_.physics, rng_);
    }
    if (fault_.kind == SensorFault::kNeverHears) return kInf;
    if (fault_.kind == SensorFault::kBlocked) return 0.3 + 0.01 * normal(rng_);
    if (fault_.kind == SensorFault::kMountedOff) sensor.yaw += fault_.yaw;
    return pingSonar(scene_, {}, base * sensor, robot_.ring.spec, robot_.physics, rng_);
  }

  void hearOthers(std::vector<double>& ranges) {
    if (fault_.kind != SensorFault::kCrosstalk || chance(rng_, 0.3)) return;
    ranges[fault_.sensor] = std::min(ranges[fault_.sensor], ranges[fault_.other]);
  }

  Scene scene_;
  SimulatedRobot robot_;
  Fault fault_;
  Rng rng_;
};

// The places are learned while the robot is well, and recognized after the fault came.
std::vector<SensorDiagnosis> examine(std::uint64_t seed, const SimulatedRobot& ring,
                                     const Fault& fault) {
  const World world = generateBuilding(BuildingKind::kCorridor, seed);
  Robot robot(world, ring, {}, seed);
  Rng rng(seed);
  const core::SonarModel model{core::SonarModelOptions()};
  core::SensorDoctor doctor{core::SonarModelOptions()};
  for (int i = 0; i < kScans; ++i) {
    const Vec2 at = world.places[static_cast<std::size_t>(i) % world.places.size()].position;
    const core::Pose2d learned_at{at.x, at.y, uniform(rng, -core::kPi, core::kPi)};
    const core::Pose2d seen_at = learned_at * core::Pose2d{0.1 * normal(rng), 0.1 * normal(rng),
                                                           uniform(rng, -core::kPi, core::kPi)};
    robot.mend();
    const auto grid = model.build(robot.scan(learned_at).readings, core::GridGeometry());
    // A sensor that dies was heard before.
    if (fault.kind != SensorFault::kDead || i >= kScans / 2) robot.breakDown(fault);
    const core::Scan scan = robot.scan(seen_at);
    const core::Pose2d error{0.03 * normal(rng), 0.03 * normal(rng), 0.02 * normal(rng)};
    doctor.examine(scan, grid, learned_at.inverse() * seen_at * error);
  }
  return doctor.diagnose();
}

Fault faultOf(std::uint64_t seed, SensorFault kind, const SensorRing& ring) {
  Rng rng(7 * seed);
  const auto count = static_cast<std::uint32_t>(ring.count);
  Fault fault{kind, static_cast<std::uint32_t>(uniformInt(rng, 0, ring.count - 1)), 0, 0.0};
  fault.other = (fault.sensor + count / 4) % count;  // in a corridor, another distance
  fault.yaw = (chance(rng, 0.5) ? 1.0 : -1.0) * uniform(rng, 14.0, 24.0) * kDegree;
  return fault;
}

TEST(SensorDoctor, NamesTheOneFaultOfEachOfTwentyRobots) {
  const SensorFault kinds[] = {SensorFault::kDead, SensorFault::kNeverHears, SensorFault::kBlocked,
                               SensorFault::kCrosstalk, SensorFault::kMountedOff};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SimulatedRobot robot = ringRobot(seed);
    const Fault fault = faultOf(seed, kinds[seed % 5], robot.ring);
    const std::string which = "robot " + std::to_string(seed) + " of " +
                              std::to_string(robot.ring.count) + " sensors, kind " +
                              std::to_string(static_cast<int>(fault.kind));
    for (const SensorDiagnosis& d : examine(seed, robot, fault)) {
      const bool faulty = d.sensor == fault.sensor;
      EXPECT_EQ(d.fault, faulty ? fault.kind : SensorFault::kNone)
          << which << ": sensor " << d.sensor << (faulty ? " (the faulty one) " : " ")
          << d.yaw_error / kDegree << " +- " << d.uncertainty / kDegree;
      if (!faulty || d.fault != fault.kind) continue;
      if (d.fault == SensorFault::kCrosstalk) {
        EXPECT_EQ(d.other, fault.other) << which;
      }
      if (d.fault == SensorFault::kBlocked) {
        EXPECT_NEAR(d.range, 0.3, 0.05) << which;
      }
      if (d.fault == SensorFault::kMountedOff) {
        EXPECT_NEAR(d.yaw_error, fault.yaw, std::max(3.0 * d.uncertainty, 5.0 * kDegree)) << which;
      }
    }
  }
}

TEST(SensorDoctor, SaysNothingOfRobotsThatAreWell) {
  for (std::uint64_t seed = 101; seed <= 120; ++seed) {
    for (const SensorDiagnosis& d : examine(seed, ringRobot(seed), {})) {
      EXPECT_EQ(d.fault, SensorFault::kNone)
          << "robot " << seed << ", sensor " << d.sensor << ": " << d.yaw_error / kDegree << " +- "
          << d.uncertainty / kDegree;
    }
  }
}

TEST(SensorDoctor, SaysNothingBeforeItHasSeenEnough) {
  core::SensorDoctor doctor{core::SonarModelOptions()};
  EXPECT_TRUE(doctor.diagnose().empty());
  core::Scan scan;
  scan.readings.assign(20, {{}, {0.4, 0.1, 4.0}, 0.2});
  doctor.examine(scan, core::EvidenceGrid(), {});
  EXPECT_EQ(doctor.scans(), 0U) << "sensors that are not told apart";
  scan.sensors.assign(20, 1);
  doctor.examine(scan, core::EvidenceGrid(), {});
  ASSERT_EQ(doctor.diagnose().size(), 1U);
  EXPECT_EQ(doctor.diagnose()[0].fault, SensorFault::kNone);
}

}  // namespace
}  // namespace place_memory::sim
