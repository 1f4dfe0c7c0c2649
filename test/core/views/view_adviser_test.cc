#include "core/views/view_adviser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/views/drawn_world.h"

namespace place_memory::core {
namespace {

using Status = ViewAdvice::Status;
using Kind = View::Kind;

constexpr double kApart = 30.0;  // of two halls that look alike [m]

/// Two halls, alike but for what is added: in the middle of each a place, and one 4 m to the west
/// and to the east of that.
class ViewAdviserTest : public testing::Test {
 protected:
  ViewAdviserTest() {
    for (const double x : {0.0, kApart}) {
      world_.addRoom(x - 7.0, -2.0, x + 7.0, 2.0);
      const PlaceId middle = world_.addPlace(x, 0.0);
      world_.addPlace(x - 4.0, 0.0, {middle});
      world_.addPlace(x + 4.0, 0.0, {middle});
    }
  }

  /// The robot may be in the middle of either, and looks to the east.
  ViewQuestion question(double probability = 0.5) const {
    ViewQuestion question;
    question.candidates = {{1, world_.pose(1), probability}, {4, world_.pose(4), 1 - probability}};
    return question;
  }

  ViewAdvice advise(const ViewQuestion& question) const {
    return ViewAdviser(world_.grids(), world_.reach()).advise(question);
  }

  DrawnWorld world_;
};

TEST_F(ViewAdviserTest, NamesTheLinkFromWhoseEndTheCandidatesDiffer) {
  world_.addBox(kApart + 5.0, -2.0, kApart + 6.0, 2.0);  // out of sight from the middle
  const ViewAdvice advice = advise(question());
  ASSERT_EQ(advice.status, Status::kFound);
  const View& view = *advice.view;
  EXPECT_EQ(view.kind, Kind::kDrive);
  EXPECT_EQ(view.places, (std::vector<PlaceId>{1, 3}));
  ASSERT_EQ(view.spots.size(), 1U);
  EXPECT_NEAR(view.spots[0].x, 4.0, 1e-9);
  EXPECT_NEAR(view.bearing, 0.0, 1e-9);
  EXPECT_NEAR(view.time, 4.0 / DrawnWorld::kSpeed, 1e-9);
  EXPECT_GT(view.information, 0.5);
  EXPECT_GT(view.probability, 0.9);
  EXPECT_EQ(advice.candidates.size(), 2U);
}

TEST_F(ViewAdviserTest, BearingsAndSpotsGoByHowTheRobotLooks) {
  world_.addBox(kApart + 5.0, -2.0, kApart + 6.0, 2.0);
  ViewQuestion turned = question();
  for (PoseCandidate& candidate : turned.candidates) candidate.map_from_base.yaw = 0.5 * kPi;
  const ViewAdvice advice = advise(turned);
  ASSERT_EQ(advice.status, Status::kFound);
  EXPECT_NEAR(advice.view->bearing, -0.5 * kPi, 1e-9);
  EXPECT_NEAR(advice.view->spots[0].y, -4.0, 1e-9);
}

TEST_F(ViewAdviserTest, WhereNothingPartsThemItSaysSo) {
  EXPECT_EQ(advise(question()).status, Status::kNoView);
  EXPECT_FALSE(advise(question()).view);
  EXPECT_EQ(advise(question()).views, 2U);
}

TEST_F(ViewAdviserTest, OneThatIsSureNeedsNone) {
  world_.addBox(kApart + 5.0, -2.0, kApart + 6.0, 2.0);
  EXPECT_EQ(advise(question(0.95)).status, Status::kSure);
  EXPECT_EQ(advise(question(0.85)).status, Status::kFound);
  EXPECT_EQ(advise({}).status, Status::kNoCandidates);
}

TEST_F(ViewAdviserTest, OneCandidateAloneIsPartedFromNothing) {
  ViewQuestion alone;
  alone.candidates = {{1, world_.pose(1), 0.2}};
  alone.sure = 2.0;
  EXPECT_EQ(advise(alone).status, Status::kNoView);
}

TEST_F(ViewAdviserTest, GoesFartherWhereOnlyThatPartsThem) {
  DrawnWorld far;
  for (const double x : {0.0, 100.0}) {
    far.addRoom(x - 3.0, -2.0, x + 18.0, 2.0);
    const PlaceId first = far.addPlace(x, 0.0);
    const PlaceId second = far.addPlace(x + 5.0, 0.0, {first});
    far.addPlace(x + 10.0, 0.0, {second});
  }
  far.addBox(11.5, -2.0, 13.0, 0.5);
  ViewQuestion question;
  question.candidates = {{1, far.pose(1), 0.5}, {4, far.pose(4), 0.5}};
  const ViewAdvice advice = ViewAdviser(far.grids(), far.reach()).advise(question);
  ASSERT_EQ(advice.status, Status::kFound);
  EXPECT_EQ(advice.view->places, (std::vector<PlaceId>{1, 2, 3}));
  ASSERT_EQ(advice.view->spots.size(), 2U);
  EXPECT_NEAR(advice.view->spots[0].x, 5.0, 1e-9);
  EXPECT_NEAR(advice.view->spots[1].x, 10.0, 1e-9);
  EXPECT_NEAR(advice.view->time, 10.0 / DrawnWorld::kSpeed, 1e-9);
}

TEST_F(ViewAdviserTest, WhatHasNotBeenLookedAtOnTheSpotIsWorthATurn) {
  world_.addBox(-1.8, -2.0, -1.3, 2.0);  // behind the robot, in the first hall
  ViewQuestion turn = question();
  EXPECT_EQ(advise(turn).view->kind, Kind::kDrive);
  // All around it has looked, and it is still not clear: that is not looked at again.
  turn.seen = SeenGrid{world_.seenFrom(world_.pose(1)), {}};
  EXPECT_EQ(advise(turn).view->kind, Kind::kDrive);
  // Ahead only.
  turn.seen = SeenGrid{world_.seenFrom(world_.pose(1), true), {}};
  const ViewAdvice advice = advise(turn);
  ASSERT_EQ(advice.status, Status::kFound);
  EXPECT_EQ(advice.view->kind, Kind::kTurn);
  EXPECT_GT(std::abs(advice.view->bearing), 0.6 * kPi);
  EXPECT_TRUE(advice.view->spots.empty());
  EXPECT_TRUE(advice.view->places.empty());
}

TEST_F(ViewAdviserTest, NeighboursThatSeeTheRobotAtOneSpotAreOneCandidate) {
  ViewQuestion three = question(0.3);
  three.candidates.push_back({3, {0.3, 0.2, 0.1}, 0.3});
  const ViewAdvice advice = advise(three);
  ASSERT_EQ(advice.candidates.size(), 2U);
  EXPECT_EQ(advice.candidates[0].place, 4);
  EXPECT_NEAR(advice.candidates[0].probability, 0.7 / 1.3, 1e-9);
  EXPECT_NEAR(advice.candidates[1].probability, 0.6 / 1.3, 1e-9);
}

TEST_F(ViewAdviserTest, OfAPlaceThatIsGoneNothingIsExpected) {
  world_.addBox(kApart + 5.0, -2.0, kApart + 6.0, 2.0);
  const ViewAdviser adviser([](PlaceId) { return nullptr; }, world_.reach());
  EXPECT_EQ(adviser.advise(question()).status, Status::kNoView);
}

// --- beside one who compares all views ---

/// A floor of places three metres apart with boxes between them by chance, each linked to those
/// beside it.
DrawnWorld randomFloor(std::mt19937& random) {
  DrawnWorld world;
  std::uniform_real_distribution<double> anywhere(-1.0, 13.0);
  for (int i = 0; i < 14; ++i) {
    const double x = anywhere(random), y = anywhere(random);
    world.addBox(x, y, x + 0.8, y + 0.4);
  }
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      std::vector<PlaceId> links;
      if (column > 0) links.push_back(4 * row + column);
      if (row > 0) links.push_back(4 * (row - 1) + column + 1);
      world.addPlace(3.0 * column, 3.0 * row, links);
    }
  }
  return world;
}

/// Information per second of the best spot to drive to, where looking about takes five seconds.
double bestRate(const DrawnWorld& world, const std::vector<PoseCandidate>& candidates) {
  double best = 0.0;
  std::vector<double> probabilities;
  for (const PoseCandidate& candidate : candidates) probabilities.push_back(candidate.probability);
  Bearings all{};
  all.fill(true);
  for (const PoseCandidate& by : candidates) {
    for (const ViewPoint& target : world.reached(by.place)) {
      const Pose2d spot = by.map_from_base.inverse() * target.map_from_place;
      if (std::hypot(spot.x, spot.y) < 1.0) continue;
      std::vector<std::vector<ExpectedView>> views(candidates.size());
      double time = 0.0, weight = 0.0;
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Pose2d there = candidates[i].map_from_base * Pose2d{spot.x, spot.y, 0.0};
        for (const ViewPoint& point : world.reached(candidates[i].place)) {
          const Pose2d place_from_there = point.map_from_place.inverse() * there;
          if (std::hypot(place_from_there.x, place_from_there.y) > 0.9) continue;
          views[i] = viewsAbout(world.seenFrom(point.map_from_place), place_from_there);
          time += candidates[i].probability * point.time;
          weight += candidates[i].probability;
        }
      }
      std::vector<std::vector<double>> likelihoods(candidates.size());
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        double known = 0.0, sum = 0.0;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
          const bool tells = !views[i].empty() && !views[k].empty();
          const double one = tells ? likeness(views[i].front(), views[k], all) : 1.0;
          likelihoods[i].push_back(one);
          known += tells ? candidates[k].probability : 0.0;
          sum += tells ? candidates[k].probability * one : 0.0;
        }
        for (std::size_t k = 0; k < candidates.size(); ++k) {
          if (!views[i].empty() && views[k].empty()) likelihoods[i][k] = sum / known;
        }
      }
      const double information = expectedAnswer(probabilities, likelihoods).information;
      if (information >= 0.1) best = std::max(best, information / (time / weight + 5.0));
    }
  }
  return best;
}

class RandomFloors : public testing::TestWithParam<unsigned> {};

TEST_P(RandomFloors, NoViewTellsMoreASecondThanTheOneThatIsNamed) {
  std::mt19937 random(GetParam());
  const DrawnWorld world = randomFloor(random);
  ViewQuestion question;
  for (const PlaceId place : {1, 6, 11, 16}) {
    const double yaw = 0.5 * kPi * static_cast<double>(random() % 4);
    const double weight = std::uniform_real_distribution<double>(0.5, 1.0)(random);
    question.candidates.push_back({place, {world.pose(place).x, world.pose(place).y, yaw}, weight});
  }
  const ViewAdvice advice = ViewAdviser(world.grids(), world.reach()).advise(question);
  const double best = bestRate(world, advice.candidates);
  ASSERT_EQ(advice.status == Status::kFound, best > 0.0);
  if (!advice.view) return;
  EXPECT_NEAR(advice.view->information / (advice.view->time + 5.0), best, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFloors, testing::Range(1U, 13U));

}  // namespace
}  // namespace place_memory::core
