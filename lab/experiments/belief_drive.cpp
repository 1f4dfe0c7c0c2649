#include "experiments/belief_drive.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/index/place_index.h"
#include "core/map/place_locator.h"
#include "core/recognize/recognizer.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::experiments {
namespace {

using core::Pose2d;

constexpr double kBucket = 1.5;  // [m]
constexpr double kSure = 0.9;
constexpr std::size_t kMatches = 32;  // of one scan

/// What odometry says of a way.
class NoisyOdometry {
 public:
  NoisyOdometry(const OdometryNoise& noise, std::uint64_t seed) : noise_(noise), random_(seed) {
    scale_ = 1.0 + noise_.scale * normal_(random_);
  }

  core::BeliefMotion along(const std::vector<Pose2d>& way) {
    core::BeliefMotion moved;
    for (const Pose2d& pose : way) {
      if (has_last_) {
        const Pose2d step = last_.inverse() * pose;
        const double length = std::hypot(step.x, step.y);
        const double turned = step.yaw + noise_.yaw * std::sqrt(length) * normal_(random_);
        moved.motion = moved.motion * Pose2d{scale_ * step.x, scale_ * step.y, turned};
        moved.way += length;
      }
      last_ = pose;
      has_last_ = true;
    }
    return moved;
  }

 private:
  OdometryNoise noise_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double scale_ = 1.0;
  Pose2d last_;
  bool has_last_ = false;
};

double sigmaAfter(double way, const OdometryNoise& noise) {
  return noise.scale * way + noise.yaw * std::sqrt(way) * way / std::sqrt(3.0);
}

bool accepts(const MatchedDrive::Scan& scan, const std::string& label) {
  return std::count(scan.accept.begin(), scan.accept.end(), label) > 0;
}

struct Shares {
  std::size_t scans = 0;
  std::size_t answers = 0;
  std::size_t single = 0;
  std::size_t right = 0;
  std::size_t sure = 0;
  std::size_t sure_and_wrong = 0;

  void add(const BeliefAnswer& answer) {
    const bool sure_of_it = answer.probability >= kSure;
    ++answers;
    single += answer.single ? 1 : 0;
    right += answer.right ? 1 : 0;
    sure += sure_of_it && answer.right ? 1 : 0;
    sure_and_wrong += sure_of_it && !answer.right ? 1 : 0;
  }

  void add(const Shares& other) {
    scans += other.scans;
    answers += other.answers;
    single += other.single;
    right += other.right;
    sure += other.sure;
    sure_and_wrong += other.sure_and_wrong;
  }

  std::vector<std::string> row(const std::string& name) const {
    const auto share = [this](std::size_t count) {
      return fixed(
          static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(answers, 1)), 3);
    };
    return {name,
            std::to_string(scans),
            share(single),
            share(right),
            share(sure),
            fixed(static_cast<double>(sure_and_wrong) /
                      static_cast<double>(std::max<std::size_t>(answers, 1)),
                  4)};
  }
};

}  // namespace

MatchedDrive matchDrive(const trials::TrialSet& set, const Method& method) {
  const core::SonarModel sonar(method.parameters.sonar);
  const core::Recognizer recognizer(method.parameters.match.recognizer);
  core::GridGeometry geometry;
  geometry.cell_size = set.cell_size;
  MatchedDrive drive;
  drive.name = set.name;
  core::PlaceIndex index;
  for (const trials::LearnedScan& scan : set.learned) {
    drive.labels.push_back(scan.label);
    drive.map_from_place.push_back(scan.odom_from_scan);
    index.put(static_cast<core::PlaceId>(drive.labels.size()),
              sonar.build(scan.readings, geometry));
  }
  const auto frames = [&](const std::vector<core::PlaceId>& ids) {
    std::vector<core::PlaceFrame> of;
    for (const core::PlaceId id : ids) {
      of.push_back({drive.map_from_place[static_cast<std::size_t>(id - 1)]});
    }
    return std::optional(of);
  };
  for (const trials::RecognitionTrial& trial : set.trials) {
    core::Scan scan;
    scan.readings = trial.readings;
    scan.grid = sonar.build(trial.readings, geometry);
    const core::Recognition found =
        recognizer.recognize(scan, index, frames, trial.heading_window).value();
    MatchedDrive::Scan& matched = drive.scans.emplace_back();
    matched.way = trial.way;
    matched.accept = trial.accept;
    const Pose2d scan_from_base{0.0, 0.0,
                                core::wrapAngle(trial.way.back().yaw - trial.odom_from_scan.yaw)};
    for (const core::PlaceMatch& match : found.matches) {
      matched.known += match.probability;
      if (matched.matches.size() == kMatches) continue;
      matched.matches.push_back({match.id, match.score, match.place_from_scan * scan_from_base});
    }
  }
  return drive;
}

std::vector<BeliefAnswer> followDrive(const MatchedDrive& drive,
                                      const core::PlaceBeliefOptions& options,
                                      const OdometryNoise& noise, std::uint64_t seed) {
  core::PlaceLocator locator(kBucket);
  for (std::size_t i = 0; i < drive.map_from_place.size(); ++i) {
    locator.put(static_cast<core::PlaceId>(i + 1), drive.map_from_place[i]);
  }
  core::PlaceBelief::Map map;
  map.places = drive.map_from_place.size();
  map.map_from_place = [&](core::PlaceId id) {
    return drive.map_from_place[static_cast<std::size_t>(id - 1)];
  };
  map.sigma = [&](double way) { return sigmaAfter(way, noise); };
  map.near = [&](const Pose2d& pose, double radius) { return locator.near(pose, radius); };
  const auto labelOf = [&](core::PlaceId id) {
    return drive.labels[static_cast<std::size_t>(id - 1)];
  };
  NoisyOdometry odometry(noise, seed);
  core::PlaceBelief belief(options);
  std::vector<BeliefAnswer> answers;
  for (const MatchedDrive::Scan& scan : drive.scans) {
    const core::BeliefMotion moved = odometry.along(scan.way);
    if (!answers.empty()) belief.predict(moved, map);
    belief.measure(scan.matches, scan.known, 1.0, map);
    BeliefAnswer& answer = answers.emplace_back();
    answer.single = !scan.matches.empty() && accepts(scan, labelOf(scan.matches.front().id));
    const core::PlaceBelief::Cluster where = belief.nearest(map);
    if (where.place == core::kNoPlace) continue;
    answer.right = accepts(scan, labelOf(where.place));
    answer.probability = where.mass;
  }
  return answers;
}

Table beliefTable(const std::vector<MatchedDrive>& drives, const core::PlaceBeliefOptions& options,
                  const OdometryNoise& noise, std::size_t seeds) {
  Table table({"drive", "scans", "one scan", "belief", "sure and right", "sure and wrong"});
  Shares all;
  for (const MatchedDrive& drive : drives) {
    Shares shares;
    shares.scans = drive.scans.size();
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      for (const BeliefAnswer& answer : followDrive(drive, options, noise, seed)) {
        shares.add(answer);
      }
    }
    table.add(shares.row(drive.name));
    all.add(shares);
  }
  table.add(all.row("all"));
  return table;
}

}  // namespace place_memory::experiments
