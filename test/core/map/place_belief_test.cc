#include "core/map/place_belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/map/place_locator.h"

namespace place_memory::core {
namespace {

/// Places along a corridor, 1.5 m apart.
struct Corridor {
  std::vector<Pose2d> poses;  ///< of place i + 1
  PlaceLocator locator{1.5};
  double sigma_per_metre = 0.0625;
  PlaceBelief::Map map;

  explicit Corridor(std::size_t places) {
    for (std::size_t i = 0; i < places; ++i) {
      poses.push_back({1.5 * static_cast<double>(i), 0.0, 0.0});
      locator.put(static_cast<PlaceId>(i + 1), poses.back());
    }
    map.places = places;
    map.map_from_place = [this](PlaceId id) { return poses[static_cast<std::size_t>(id - 1)]; };
    map.sigma = [this](double way) { return sigma_per_metre * way; };
    map.near = [this](const Pose2d& pose, double radius) { return locator.near(pose, radius); };
  }
};

/// The same filter with a number for every place, none left out: the oracle.
class FullBelief {
 public:
  FullBelief(const PlaceBeliefOptions& options, const PlaceBelief::Map& map)
      : options_(options),
        map_(map),
        mass_(map.places, 0.5 / static_cast<double>(map.places)),
        own_(map.places, false),
        pose_(map.places) {}

  void predict(const Pose2d& motion, double share) {
    const double lifted = 1.0 - std::pow(1.0 - options_.lifted, share);
    const double stays = std::pow(options_.off_map_stays, share);
    std::vector<double> next(mass_.size(), 0.0), heaviest(mass_.size(), 0.0);
    std::vector<bool> own(mass_.size(), false);
    std::vector<Pose2d> pose(mass_.size());
    double fallen = 0.0, unseen = 0.0, all_unseen = 0.0;
    std::size_t unseen_places = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      if (!own_[i]) {
        unseen += mass_[i];
        continue;
      }
      const Pose2d at = map_.map_from_place(static_cast<PlaceId>(i + 1)) * pose_[i] * motion;
      const auto near = map_.near(at, options_.region);
      if (near.empty()) {
        fallen += mass_[i];
        continue;
      }
      const PlaceId to = near.front().id;
      const auto j = static_cast<std::size_t>(to - 1);
      next[j] += mass_[i];
      own[j] = true;
      if (mass_[i] > heaviest[j]) {
        heaviest[j] = mass_[i];
        pose[j] = map_.map_from_place(to).inverse() * at;
      }
    }
    const double anywhere = lifted * (1.0 - off_ - fallen) + (1.0 - stays) * (off_ + fallen);
    for (double& mass : next) mass *= 1.0 - lifted;
    all_unseen = (1.0 - lifted) * unseen + anywhere;
    for (const bool is_own : own) unseen_places += is_own ? 0 : 1;
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (!own[i]) next[i] = all_unseen / static_cast<double>(unseen_places);
    }
    off_ = stays * (off_ + fallen);
    mass_ = next;
    own_ = own;
    pose_ = pose;
    normalize();
  }

  void measure(const std::vector<BeliefMatch>& matches, double known, double share) {
    double best = -INFINITY, worst = INFINITY;
    for (const BeliefMatch& match : matches) best = std::max(best, match.score);
    for (const BeliefMatch& match : matches) worst = std::min(worst, match.score);
    double sum = 0.0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      double likelihood = std::max(std::exp((worst - best) / options_.softening), options_.floor);
      double alone = likelihood;
      for (const BeliefMatch& match : matches) {
        if (match.id != static_cast<PlaceId>(i + 1)) continue;
        likelihood = std::max(std::exp((match.score - best) / options_.softening), options_.floor);
        alone = likelihood;
        if (own_[i]) {
          const double off = std::hypot(match.place_from_base.x - pose_[i].x,
                                        match.place_from_base.y - pose_[i].y) /
                             options_.pose_sigma;
          likelihood *= std::max(std::exp(-0.5 * off * off), options_.pose_floor);
          likelihood = std::max(likelihood, options_.floor);
        }
        // All matches of these tests agree with the pose.
        pose_[i] = match.place_from_base;
        own_[i] = true;
      }
      mass_[i] *= std::pow(likelihood, share);
      sum += alone;
    }
    const double sure = std::clamp(known, 0.01, 0.99);
    off_ *= std::pow((1.0 - sure) / sure, options_.off_map_softening * share) *
            std::pow(sum / static_cast<double>(mass_.size()), share);
    normalize();
  }

  double offMap() const { return off_; }
  double of(PlaceId id) const { return mass_[static_cast<std::size_t>(id - 1)]; }

 private:
  void normalize() {
    double all = off_;
    for (const double mass : mass_) all += mass;
    for (double& mass : mass_) mass /= all;
    off_ /= all;
  }

  PlaceBeliefOptions options_;
  const PlaceBelief::Map& map_;
  std::vector<double> mass_;
  std::vector<bool> own_;
  std::vector<Pose2d> pose_;
  double off_ = 0.5;
};

TEST(PlaceBelief, AgreesWithAFilterOverEveryPlace) {
  const Corridor corridor(40);
  const PlaceBeliefOptions options;
  PlaceBelief belief(options);
  FullBelief full(options, corridor.map);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double x = 6.0;
  for (int step = 0; step < 30; ++step) {
    x += 0.5;
    belief.predict({{0.5, 0.0, 0.0}, 0.5, 0.5}, corridor.map);
    full.predict({0.5, 0.0, 0.0}, 0.5);
    // The place where it is, and two others that look alike, all as odometry would have them.
    std::vector<BeliefMatch> matches;
    const auto here = static_cast<std::int64_t>(std::lround(x / 1.5));
    for (const std::int64_t other : {here, here + 8, here + 15}) {
      if (other >= 40) continue;
      matches.push_back(
          {other + 1, 4.0 * unit(random), {x - 1.5 * static_cast<double>(here), 0.0, 0.0}});
    }
    const double known = 0.3 + 0.6 * unit(random);
    belief.measure(matches, known, 0.5, corridor.map);
    full.measure(matches, known, 0.5);
    EXPECT_NEAR(belief.offMap(), full.offMap(), 1e-6);
    for (PlaceId id = 1; id <= 40; ++id) {
      EXPECT_NEAR(belief.probability(id, corridor.map), full.of(id), 1e-6) << step << " " << id;
    }
  }
}

TEST(PlaceBelief, SeveralScansTellLookAlikesApart) {
  const Corridor corridor(60);
  PlaceBelief belief({});
  for (int step = 0; step < 8; ++step) {
    const auto here = static_cast<PlaceId>(10 + step);
    belief.predict({{1.5, 0.0, 0.0}, 1.5}, corridor.map);
    // The right one scores second; what scores best is somewhere else each time.
    belief.measure(
        {{static_cast<PlaceId>(50 - 3 * step), 2.0, {}}, {here, 1.5, {}}, {60, -6.0, {}}}, 0.8, 1.0,
        corridor.map);
  }
  EXPECT_EQ(belief.largest(corridor.map).place, 17);
  EXPECT_GT(belief.largest(corridor.map).mass, 0.8);
  EXPECT_LT(belief.lost(corridor.map), 0.2);
}

TEST(PlaceBelief, ARobotThatIsCarriedAwayIsLostAndFindsItself) {
  const Corridor corridor(60);
  PlaceBelief belief({});
  belief.setTo(10, {});
  for (int step = 1; step <= 3; ++step) {
    belief.predict({{1.5, 0.0, 0.0}, 1.5}, corridor.map);
    belief.measure({{40 + step, 5.0, {}}, {60, -9.0, {}}}, 0.9, 1.0, corridor.map);
    if (step == 1) {
      EXPECT_GT(belief.lost(corridor.map), 0.05);
    }
  }
  EXPECT_EQ(belief.largest(corridor.map).place, 43);
  EXPECT_GT(belief.largest(corridor.map).mass, 0.9);
}

TEST(PlaceBelief, WhatOdometryLosesOnALongWayIsMadeUpForByTheNextMatch) {
  Corridor corridor(60);
  PlaceBelief belief({});
  belief.setTo(10, {});
  // It is at place 33 in truth, two metres and a half from where odometry has it, and so far off
  // that may well be; another place far away matches a little better.
  belief.predict({{32.0, 0.0, 0.0}, 32.0}, corridor.map);
  belief.measure({{55, 3.5, {}}, {33, 3.0, {}}, {1, -6.0, {}}}, 0.8, 1.0, corridor.map);
  EXPECT_EQ(belief.largest(corridor.map).place, 33);
  EXPECT_GT(belief.largest(corridor.map).mass, 0.8);
  // Where odometry is sure to be right, nothing like it is believed.
  corridor.sigma_per_metre = 0.003;
  belief.setTo(10, {});
  belief.predict({{32.0, 0.0, 0.0}, 32.0}, corridor.map);
  belief.measure({{55, 3.5, {}}, {33, 3.0, {}}, {1, -6.0, {}}}, 0.8, 1.0, corridor.map);
  EXPECT_LT(belief.probability(33, corridor.map), 0.3);
}

TEST(PlaceBelief, BeyondTheLastPlaceItIsOffTheMap) {
  const Corridor corridor(10);
  PlaceBelief belief({});
  belief.setTo(10, {});
  for (int step = 0; step < 4; ++step) {
    belief.predict({{1.5, 0.0, 0.0}, 1.5}, corridor.map);
    belief.measure({{3, 0.5, {}}, {7, 0.4, {}}}, 0.05, 1.0, corridor.map);
  }
  EXPECT_GT(belief.offMap(), 0.7);
}

/// Drives along a corridor of which ten places match each scan; returns how often the map was
/// asked.
std::size_t questionsAlong(std::size_t places) {
  Corridor corridor(places);
  PlaceBelief::Map map = corridor.map;
  std::size_t questions = 0;
  map.map_from_place = [&](PlaceId id) {
    ++questions;
    return corridor.map.map_from_place(id);
  };
  map.near = [&](const Pose2d& pose, double radius) {
    ++questions;
    return corridor.map.near(pose, radius);
  };
  PlaceBelief belief({});
  belief.setTo(50, {});
  for (PlaceId step = 0; step < 20; ++step) {
    belief.predict({{1.5, 0.0, 0.0}, 1.5}, map);
    std::vector<BeliefMatch> matches{{51 + step, 3.0, {}}};
    for (PlaceId other = 1; other < 10; ++other) matches.push_back({90 * other + step, 2.0, {}});
    belief.measure(matches, 0.8, 1.0, map);
  }
  EXPECT_EQ(belief.largest(map).place, 70);
  return questions;
}

TEST(PlaceBelief, AnUpdateTouchesNoMoreAmongAHundredThousandPlaces) {
  EXPECT_LE(questionsAlong(100000), questionsAlong(1000));
}

TEST(PlaceBelief, AScanThatTellsNothingChangesNothing) {
  const Corridor corridor(60);
  PlaceBelief belief({});
  belief.setTo(10, {});
  belief.predict({{1.5, 0.0, 0.0}, 1.5}, corridor.map);
  const double before = belief.probability(11, corridor.map);
  belief.measure({{40, 19.4, {}}, {41, 19.4, {}}}, 0.0, 1.0, corridor.map);
  EXPECT_EQ(belief.probability(11, corridor.map), before);
  // Where all places fit alike, the ones that were left out do so, too.
  belief.measure({{40, 19.4, {}}, {41, 19.3, {}}}, 0.5, 1.0, corridor.map);
  EXPECT_EQ(belief.largest(corridor.map).place, 11);
  EXPECT_GT(belief.probability(11, corridor.map), 0.9 * before);
}

TEST(PlaceBelief, NeighboursThatPutTheRobotAtOneSpotSpeakForThePlaceThere) {
  const Corridor corridor(60);
  PlaceBelief belief({});
  for (int scan = 0; scan < 6; ++scan) {
    belief.measure({{11, 5.0, {0.1, 0.0, 0.0}}, {12, 5.0, {-1.4, 0.0, 0.0}}, {60, -9.0, {}}}, 0.9,
                   1.0, corridor.map);
  }
  EXPECT_LT(belief.probability(11, corridor.map), 0.6);
  EXPECT_EQ(belief.nearest(corridor.map).place, 11);
  EXPECT_GT(belief.nearest(corridor.map).mass, 0.99);
}

TEST(PlaceBelief, APlaceThatIsGoneIsNotAskedFor) {
  Corridor corridor(10);
  PlaceBelief belief({});
  belief.setTo(4, {});
  belief.forget(4);
  corridor.map.map_from_place = [](PlaceId id) {
    EXPECT_NE(id, 4);
    return Pose2d{1.5 * static_cast<double>(id - 1), 0.0, 0.0};
  };
  belief.predict({{0.5, 0.0, 0.0}, 0.5}, corridor.map);
  EXPECT_EQ(belief.largest(corridor.map).place, kNoPlace);
  EXPECT_DOUBLE_EQ(belief.lost(corridor.map), 1.0);
}

TEST(PlaceBelief, NoPlacesNoBelief) {
  const Corridor none(0);
  PlaceBelief belief({});
  belief.predict({{0.5, 0.0, 0.0}, 0.5}, none.map);
  belief.measure({}, 0.0, 1.0, none.map);
  EXPECT_DOUBLE_EQ(belief.offMap(), 1.0);
  EXPECT_EQ(belief.largest(none.map).place, kNoPlace);
}

}  // namespace
}  // namespace place_memory::core
