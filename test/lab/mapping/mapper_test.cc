#include "core/mapping/mapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "config/load_parameters.h"
#include "sim/scene/world_loader.h"
#include "trials/simulated_drive.h"

namespace place_memory::core {
namespace {

/// The office of the paper's third experiment, driven through by a robot of sixteen sonars.
trials::Drive officeDriveOf(double way, bool changes) {
  trials::DriveRecipe recipe;
  recipe.way = way;
  recipe.changes = changes;
  return trials::simulateDrive(
      sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/office.yaml"), {},
      recipe, 101);
}

const trials::Drive& officeDrive() {
  static const trials::Drive kDrive = officeDriveOf(130.0, true);
  return kDrive;
}

MapperOptions options() {
  const config::Parameters parameters = config::loadParameters({});
  MapperOptions options;
  options.recognizer = parameters.match.recognizer;
  options.sonar = parameters.sonar;
  return options;
}

std::chrono::nanoseconds stampOf(double t) {
  return std::chrono::nanoseconds(std::llround(t * 1e9));
}

/// Drives `drive` from one moment to another; returns what became of its scans.
std::vector<ScanDecision> drive(Mapper& mapper, const trials::Drive& moments, bool compass,
                                std::size_t first = 0, std::size_t last = 1U << 30U) {
  for (std::size_t i = first; i < std::min(last, moments.size()); ++i) {
    const trials::DriveMoment& moment = moments[i];
    if (compass && moment.heading) mapper.addHeading(stampOf(moment.t), *moment.heading);
    mapper.addOdometry(stampOf(moment.t), moment.odom);
    for (const SonarReading& reading : moment.readings) {
      mapper.addReading(stampOf(moment.t), moment.odom, reading);
    }
  }
  return mapper.takeDecisions();
}

Pose2d truthAt(const trials::Drive& moments, std::chrono::nanoseconds stamp) {
  for (const trials::DriveMoment& moment : moments) {
    if (stampOf(moment.t) >= stamp) return *moment.truth;
  }
  return *moments.back().truth;
}

/// Largest error between neighbouring places' relative poses and the truth [m].
double worstLink(const Mapper& mapper, const trials::Drive& moments) {
  const std::vector<MappedPlace> places = mapper.places();
  double worst = 0.0;
  for (const MappedPlace& a : places) {
    for (const MappedPlace& b : places) {
      const Pose2d true_a = truthAt(moments, a.stamp), true_b = truthAt(moments, b.stamp);
      const Pose2d truth = true_a.inverse() * true_b;
      if (a.id >= b.id || std::hypot(truth.x, truth.y) > 3.0) continue;
      const Pose2d got = a.map_from_base.inverse() * b.map_from_base;
      worst = std::max(worst, std::hypot(got.x - truth.x, got.y - truth.y));
    }
  }
  return worst;
}

class MapperDrive : public testing::TestWithParam<bool> {};

TEST_P(MapperDrive, MapsTheOfficeAndKnowsItsPlacesAgain) {
  Mapper mapper(options());
  const std::vector<ScanDecision> decisions = drive(mapper, officeDrive(), GetParam());
  EXPECT_GT(mapper.places().size(), 20U);
  EXPECT_LT(worstLink(mapper, officeDrive()), 0.6);
  std::map<PlaceId, MappedPlace> places;
  for (const MappedPlace& place : mapper.places()) places[place.id] = place;
  int named = 0;
  for (const ScanDecision& decision : decisions) {
    if (decision.kind == ScanDecision::Kind::kNewPlace || !places.count(decision.place)) continue;
    const Pose2d truth = truthAt(officeDrive(), places[decision.place].stamp).inverse() *
                         truthAt(officeDrive(), decision.stamp);
    EXPECT_LT(
        std::hypot(truth.x - decision.place_from_base.x, truth.y - decision.place_from_base.y),
        0.75);
    ++named;
  }
  EXPECT_GT(named, 60);
}

TEST_P(MapperDrive, LocalizesOnAMapThatStaysAndFromAnywhere) {
  Mapper mapper(options());
  drive(mapper, officeDrive(), GetParam());
  const std::vector<MappedPlace> before = mapper.places();
  mapper.setMode(MapperMode::kLocalize);
  for (const std::size_t first : {300U, 1100U, 2500U}) {
    mapper.beginSession();
    EXPECT_FALSE(mapper.mapFromOdom());
    EXPECT_EQ(mapper.lost(), 1.0);
    drive(mapper, officeDrive(), GetParam(), first, first + 200);
    ASSERT_TRUE(mapper.mapFromOdom()) << first;
    EXPECT_LT(mapper.lost(), 0.2);
    EXPECT_FALSE(mapper.belief().places.empty());
  }
  const std::vector<MappedPlace> after = mapper.places();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].map_from_base.x, before[i].map_from_base.x);
    EXPECT_EQ(after[i].map_from_base.yaw, before[i].map_from_base.yaw);
  }
}

TEST_P(MapperDrive, ALaterSessionJoinsTheMap) {
  Mapper mapper(options());
  const std::size_t half = officeDrive().size() / 2;
  drive(mapper, officeDrive(), GetParam(), 0, half);
  mapper.beginSession();
  drive(mapper, officeDrive(), GetParam(), half);
  for (const MappedPlace& place : mapper.places()) EXPECT_FALSE(place.apart);
  EXPECT_LT(worstLink(mapper, officeDrive()), 0.6);
}

INSTANTIATE_TEST_SUITE_P(Compass, MapperDrive, testing::Bool());

TEST(Mapper, AtAPersonsWordTheRobotIsWhereTooFewScansSaySo) {
  Mapper mapper(options());
  std::optional<ClosureQuestion> asked;
  for (std::size_t i = 0; i < officeDrive().size() && !asked; ++i) {
    drive(mapper, officeDrive(), false, i, i + 1);
    if (!mapper.closureQuestions().empty()) asked = mapper.closureQuestions().front();
  }
  ASSERT_TRUE(asked);
  EXPECT_LT(asked->scans, options().closure.witnesses);
  mapper.takeEvents();
  EXPECT_EQ(mapper.confirmClosure(asked->place), ClosureWord::kDone);
  const std::vector<MapperEvent> events = mapper.takeEvents();
  ASSERT_FALSE(events.empty());
  const MapperEvent& newest = events.back();  // before it the way may have been parted
  EXPECT_TRUE(newest.kind == MapperEvent::Kind::kClosed ||
              newest.kind == MapperEvent::Kind::kJoined);
  EXPECT_EQ(std::count(newest.witnesses.begin(), newest.witnesses.end(), asked->place), 1);
  EXPECT_TRUE(mapper.mapFromOdom());
  EXPECT_TRUE(mapper.closureQuestions().empty());
}

TEST(Mapper, TheSameDataGivesTheSameMap) {
  Mapper one(options()), other(options());
  drive(one, officeDrive(), true, 0, 2000);
  for (std::size_t i = 0; i < 2000; i += 7) {
    drive(other, officeDrive(), true, i, std::min<std::size_t>(i + 7, 2000));
  }
  ASSERT_EQ(one.places().size(), other.places().size());
  for (std::size_t i = 0; i < one.places().size(); ++i) {
    EXPECT_EQ(one.places()[i].map_from_base.x, other.places()[i].map_from_base.x);
  }
}

TEST(Mapper, AMapThatWasKeptServesAgain) {
  Mapper mapper(options());
  drive(mapper, officeDrive(), true);
  const KeptMap kept = mapper.map();
  MapperOptions localize = options();
  localize.mode = MapperMode::kLocalize;
  Mapper later(localize);
  later.restore(kept);
  EXPECT_FALSE(later.mapFromOdom());
  drive(later, officeDrive(), true, 1100, 1300);
  EXPECT_TRUE(later.mapFromOdom());
  ASSERT_EQ(later.places().size(), mapper.places().size());
  EXPECT_EQ(later.places().back().id, mapper.places().back().id);
  EXPECT_THROW(later.restore(kept), std::invalid_argument);
  KeptMap damaged = kept;
  damaged.nodes[5].pose.x = NAN;
  EXPECT_THROW(Mapper(localize).restore(damaged), std::invalid_argument);
}

TEST(Mapper, LapsDoNotMakeTheMapGrow) {
  trials::DriveRecipe recipe;
  recipe.way = 400.0;
  recipe.people = 0;
  recipe.changes = false;
  const trials::Drive laps = trials::simulateDrive(
      sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/rooms.yaml"), {},
      recipe, 9);
  MapperOptions thinned = options();
  thinned.thinning.visits = 6;
  Mapper mapper(thinned);
  drive(mapper, laps, true, 0, laps.size() / 2);
  const std::size_t half = mapper.graph().nodes().size();
  drive(mapper, laps, true, laps.size() / 2);
  EXPECT_LT(mapper.graph().nodes().size(), half + 40);
  EXPECT_LT(mapper.graph().nodes().size(), 9 * mapper.places().size() + 130);
  EXPECT_LT(worstLink(mapper, laps), 0.6);
}

TEST(Mapper, StandingStillMakesNothingAndMovesNothing) {
  Mapper mapper(options());
  drive(mapper, officeDrive(), true, 0, 1500);
  const std::vector<MappedPlace> before = mapper.places();
  const std::size_t nodes = mapper.graph().nodes().size();
  trials::DriveMoment moment = officeDrive()[1500];
  for (int i = 0; i < 6000; ++i) {
    moment.t += 0.1;
    moment.odom.x += i % 2 ? 0.003 : -0.003;
    drive(mapper, {moment}, true);
  }
  EXPECT_EQ(mapper.graph().nodes().size(), nodes);
  ASSERT_EQ(mapper.places().size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(mapper.places()[i].map_from_base.x, before[i].map_from_base.x);
  }
}

TEST(Mapper, AStrangersBuildingIsNotTakenForTheMap) {
  trials::DriveRecipe recipe;
  recipe.way = 60.0;
  const trials::Drive stranger = trials::simulateDrive(
      sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/hallway.yaml"), {},
      recipe, 5);
  Mapper mapper(options());
  drive(mapper, officeDrive(), true);
  mapper.beginSession();
  drive(mapper, stranger, true);
  EXPECT_FALSE(mapper.mapFromOdom());
  EXPECT_EQ(mapper.lost(), 1.0);
}

TEST(Mapper, ARobotThatIsCarriedWhileItMapsFindsBack) {
  const trials::Drive office = officeDriveOf(230.0, false);
  Mapper mapper(options());
  // From half way on it is put down where it would have come to lie farthest off soon after.
  const std::size_t from = office.size() / 2;
  std::size_t to = from;
  double farthest = 0.0;
  for (std::size_t i = from; i < office.size() * 65 / 100; ++i) {
    const double off = std::hypot(office[i].truth->x - office[from].truth->x,
                                  office[i].truth->y - office[from].truth->y);
    if (off <= farthest) continue;
    farthest = off;
    to = i;
  }
  ASSERT_GT(farthest, 6.0);
  drive(mapper, office, true, 0, from);
  const Pose2d gone = office[from - 1].odom * office[to].odom.inverse();
  trials::Drive rest(office.begin() + static_cast<std::ptrdiff_t>(to), office.end());
  double most_lost = 0.0;
  for (trials::DriveMoment& moment : rest) {
    moment.odom = gone * moment.odom;
    drive(mapper, {moment}, true);
    most_lost = std::max(most_lost, mapper.lost());
  }
  EXPECT_GT(most_lost, 0.95);
  EXPECT_TRUE(mapper.mapFromOdom());
  EXPECT_LT(mapper.lost(), 0.2);
}

}  // namespace
}  // namespace place_memory::core
