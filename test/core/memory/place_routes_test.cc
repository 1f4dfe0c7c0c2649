#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <memory>
#include <string>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;
using Status = RouteAnswer::Status;
using std::chrono::seconds;

class PlaceRoutesTest : public testing::Test {
 protected:
  static Scan scanAt(unsigned seed, double x, int begin) {
    Scan scan = makeRandomScan(seed);
    scan.id = static_cast<std::uint64_t>(begin);
    scan.odom_from_scan = {x, 0.0, 0.0};
    scan.robot_in_scan = {0.0, 0.0, 0.0};
    scan.begin = seconds(begin);
    scan.end = seconds(begin + 5);
    return scan;
  }

  PlaceMemoryOptions options() const {
    PlaceMemoryOptions options;
    options.store_path = folder_.file("places.db");
    options.recognizer.calibration.right = {-20.0, 0.0, 0.0, 0.0, 30.0};
    options.recognizer.calibration.known = {-20.0};
    options.clock = [this] { return now_; };
    return options;
  }

  // Three places in a row, of which each took ten seconds to come to.
  PlaceRoutesTest() {
    memory_ = std::make_unique<PlaceMemory>(options());
    memory_->learn(scanAt(1, 0.0, 1000), "a");
    memory_->learn(scanAt(2, 2.0, 1015), "b");
    memory_->learn(scanAt(3, 4.0, 1030), "c");
  }

  RoutePlan plan(const std::string& goal) {
    RouteQuery query;
    query.goal.label = goal;
    return memory_->plan(query);
  }

  static std::vector<std::string> labels(const std::vector<Place>& places) {
    std::vector<std::string> labels;
    for (const Place& place : places) labels.push_back(place.label);
    return labels;
  }

  Reason refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const PlaceMemoryError& error) {
      return error.reason();
    }
    ADD_FAILURE() << "nothing was refused";
    return Reason::kStoreFailed;
  }

  const TemporaryFolder folder_;
  std::chrono::nanoseconds now_ = seconds(2000);
  std::unique_ptr<PlaceMemory> memory_;
};

TEST_F(PlaceRoutesTest, ARouteLeadsFromWhereTheRobotIs) {
  const RoutePlan plan = this->plan("a");
  ASSERT_EQ(plan.answer.status, Status::kFound);
  EXPECT_EQ(labels(plan.best), (std::vector<std::string>{"c", "b", "a"}));
  EXPECT_NEAR(plan.answer.best.time, 20.0, 1e-9);
  EXPECT_TRUE(plan.second.empty());
}

TEST_F(PlaceRoutesTest, EndsAreNamedByIdLabelOrPose) {
  RouteQuery query;
  query.start = RouteEnd{1, "", std::nullopt};
  query.goal.pose = Pose2d{2.3, 0.4, 0.0};
  EXPECT_EQ(labels(memory_->plan(query).best), (std::vector<std::string>{"a", "b"}));
  query.goal = {3, "no matter", std::nullopt};
  EXPECT_EQ(memory_->plan(query).best.back().label, "c");
  query.goal = {0, "nowhere", std::nullopt};
  const RoutePlan lost = memory_->plan(query);
  EXPECT_EQ(lost.answer.status, Status::kUnknownGoal);
  EXPECT_NE(lost.answer.reason.find("\"nowhere\""), std::string::npos);
  query.start = RouteEnd{0, "nowhere", std::nullopt};
  EXPECT_EQ(memory_->plan(query).answer.status, Status::kUnknownStart);
}

TEST_F(PlaceRoutesTest, WithoutAStartARobotThatIsLostIsTold) {
  memory_->forgetWhereabouts();
  const RoutePlan plan = this->plan("a");
  EXPECT_EQ(plan.answer.status, Status::kNotLocalized);
  EXPECT_NE(plan.answer.reason, "");
  RouteQuery query;
  query.starts = {{2, 0.7}, {3, 0.3}};
  query.goal.label = "a";
  EXPECT_EQ(labels(memory_->plan(query).best), (std::vector<std::string>{"b", "a"}));
}

TEST_F(PlaceRoutesTest, DrivingTeachesTheLinksHowLongTheyTake) {
  const PlaceLink link = memory_->map().links.front();
  EXPECT_EQ(link.forward.succeeded, 1U);
  EXPECT_EQ(link.forward.through, 1.0);
  EXPECT_DOUBLE_EQ(link.forward.time, 10.0);
  EXPECT_EQ(link.forward.last, seconds(1015));
  memory_->recognize(scanAt(2, 2.0, 1055), kHeadingWindow);
  const PlaceLink back = memory_->map().links.back();
  EXPECT_DOUBLE_EQ(back.backward.time, 20.0);
  EXPECT_EQ(back.backward.succeeded, 1U);
  const std::vector<Traversal> history = memory_->traversals();
  ASSERT_EQ(history.size(), 3U);
  EXPECT_EQ(history[2], (Traversal{3, 2, seconds(1035), seconds(1055), true, "scans"}));
}

TEST_F(PlaceRoutesTest, AWayThatWasReportedIsNotCountedAgainByTheScanAtItsEnd) {
  memory_->reportTraversal({3, 2, seconds(1040), seconds(1050), true, "goal"});
  memory_->recognize(scanAt(2, 2.0, 1055), kHeadingWindow);
  EXPECT_EQ(memory_->map().links.back().backward.succeeded, 1U);
  memory_->recognize(scanAt(3, 4.0, 1075), kHeadingWindow);
  EXPECT_EQ(memory_->map().links.back().forward.succeeded, 2U) << "the next way counts as before";
}

TEST_F(PlaceRoutesTest, WhatIsReportedIsLearnedAndKept) {
  const double before = memory_->linkOdds(1, 2).second;
  const Traversal failed{2, 1, seconds(1100), seconds(1130), false, "teleop"};
  memory_->reportTraversal(failed);
  EXPECT_LT(memory_->linkOdds(1, 2).second, before);
  const PlaceLink link = memory_->map().links.front();
  EXPECT_EQ(link.backward.failed, 1U);
  EXPECT_DOUBLE_EQ(link.backward.lost_time, 30.0);
  memory_.reset();
  const PlaceMemory again(options());
  EXPECT_EQ(again.map().links.front(), link);
  EXPECT_EQ(again.traversals().back(), failed);
}

TEST_F(PlaceRoutesTest, HoursAtWhichADoorIsOpenAreKnownAfterARestart) {
  for (int day = 1; day <= 12; ++day) {
    for (const int hour : {8, 10, 14, 16}) {
      const std::chrono::nanoseconds time = std::chrono::hours(24 * day + hour);
      now_ = time;
      memory_->reportTraversal({2, 3, time, time, hour < 12, "test"});
    }
  }
  const auto oddsAt = [this](int hour) {
    now_ = std::chrono::hours(24 * 13 + hour);
    return memory_->linkOdds(2, 3).first;
  };
  const double morning = oddsAt(9), afternoon = oddsAt(15);
  EXPECT_GT(morning, 0.8);
  EXPECT_LT(afternoon, 0.3);
  memory_.reset();
  memory_ = std::make_unique<PlaceMemory>(options());
  EXPECT_NEAR(oddsAt(9), morning, 1e-9);
  EXPECT_NEAR(oddsAt(15), afternoon, 1e-9);
}

TEST_F(PlaceRoutesTest, WhatCannotBeIsRefused) {
  const Traversal good{1, 2, seconds(1), seconds(2), true, ""};
  Traversal wrong = good;
  wrong.to = 9;
  EXPECT_EQ(refusal([&] { memory_->reportTraversal(wrong); }), Reason::kUnknownPlace);
  wrong.to = 3;
  EXPECT_EQ(refusal([&] { memory_->reportTraversal(wrong); }), Reason::kUnknownLink);
  wrong = good;
  wrong.begin = seconds(3);
  EXPECT_EQ(refusal([&] { memory_->reportTraversal(wrong); }), Reason::kInvalidTraversal);
  wrong = good;
  wrong.end = seconds(4294967295);
  EXPECT_EQ(refusal([&] { memory_->reportTraversal(wrong); }), Reason::kInvalidTraversal);
  wrong = good;
  wrong.source = "\x01";
  EXPECT_EQ(refusal([&] { memory_->reportTraversal(wrong); }), Reason::kInvalidTraversal);
  for (const double toll : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(refusal([&] { memory_->setLink(1, 2, LinkOrder::kToll, toll, true); }),
              Reason::kInvalidTraversal);
  }
  EXPECT_EQ(refusal([&] { memory_->setLink(1, 3, LinkOrder::kBlock, 0.0, true); }),
            Reason::kUnknownLink);
  EXPECT_EQ(memory_->traversals().size(), 2U);
}

TEST_F(PlaceRoutesTest, APersonBlocksForbidsAndFreesLinks) {
  memory_->setLink(1, 2, LinkOrder::kBlock, 0.0, false);
  EXPECT_NEAR(memory_->linkOdds(1, 2).first, kLeastOdds, 1e-9);
  EXPECT_GT(memory_->linkOdds(1, 2).second, 0.5);
  memory_->setLink(1, 2, LinkOrder::kForbid, 0.0, true);
  EXPECT_EQ(memory_->linkOdds(1, 2), (std::pair{0.0, 0.0}));
  EXPECT_EQ(plan("a").answer.status, Status::kNoRoute);
  memory_->setLink(2, 1, LinkOrder::kUnblock, 0.0, true);
  EXPECT_EQ(plan("a").answer.status, Status::kFound);
  EXPECT_GT(memory_->linkOdds(1, 2).first, 0.5);
  memory_->setLink(2, 1, LinkOrder::kToll, 60.0, false);
  const RoutePlan dear = plan("a");
  EXPECT_GT(dear.answer.best.cost, 80.0);
  EXPECT_NEAR(dear.answer.best.time, 20.0, 1e-9);
  EXPECT_EQ(memory_->traversals().size(), 2U);  // nobody went anywhere
}

}  // namespace
}  // namespace place_memory::core
