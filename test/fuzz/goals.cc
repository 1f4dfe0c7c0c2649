#include <ros/serialization.h>

#include <cmath>
#include <exception>
#include <memory>

#include "config/load_parameters.h"
#include "core/drive/goal_run.h"
#include "core/random_scan.h"
#include "core/store/packed_bytes.h"
#include "fuzz/targets.h"
#include "node/go/explore_run.h"
#include "node/go/go_goal.h"

namespace place_memory::fuzz {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr int kMostDeeds = 64;
constexpr int kMostMoves = 16;  // of one who explores, who thinks about each

/// Three places in a row, linked, which no goal changes.
core::PlaceMemory& memory() {
  static const std::unique_ptr<core::PlaceMemory> memory = [] {
    core::PlaceMemoryOptions options;
    options.recognizer.threads = 1;
    options.clock = [] { return std::chrono::seconds(2000); };
    auto made = std::make_unique<core::PlaceMemory>(options);
    for (unsigned i = 1; i <= 3; ++i) {
      core::Scan scan = core::makeRandomScan(i);
      scan.id = i;
      scan.odom_from_scan = {2.0 * i, 0.0, 0.0};
      scan.begin = std::chrono::seconds(1000 + 10 * i);
      scan.end = scan.begin + std::chrono::seconds(5);
      made->learn(scan, std::string(1, static_cast<char>('`' + i)), true);
    }
    return made;
  }();
  return *memory;
}

/// Drives, or does not, to where a goal of ~go_to_place leads.
class Goer {
 public:
  explicit Goer(const core::RouteEnd& end) : end_(end), run_(hooks(), end.pose, "fuzz") {}

  void run(core::ByteUnpacker& bytes) {
    run_.begin({2.0, 0.0, 0.0}, now_);
    for (int deeds = 0; bytes.left() > 0 && deeds < kMostDeeds && !run_.isOver(); ++deeds) {
      check();
      now_ += milliseconds(bytes.take<std::uint16_t>());
      act(bytes);
    }
    require(!run_.isOver() || run_.message().size() > 3, "over without a reason");
  }

 private:
  void act(core::ByteUnpacker& bytes) {
    switch (bytes.take<std::uint8_t>() % 4) {
      case 0:
        return run_.arrived(now_);
      case 1:
        return run_.blocked("a chair stands there", now_);
      case 2:
        return run_.placeRemoved(bytes.take<std::int8_t>(), now_);
      default:
        return run_.follow([](core::PlaceId id) { return memory().place(id); }, now_);
    }
  }

  void check() const {
    require(run_.leg().has_value(), "under way, and nowhere to go");
    require(run_.leg()->target.isFinite(), "a leg without an end");
    const double left = run_.timeLeft(1.0);
    require(left >= 0.0 && std::isfinite(left), "a time that is none");
    require(!run_.legInWords().empty() && run_.legsLeft() > 0, "a leg that is none");
  }

  core::GoalRun::Hooks hooks() {
    core::GoalRun::Hooks hooks;
    hooks.plan = [this](const core::GoalRun::Wish& wish) {
      core::RouteQuery query;
      query.goal = end_;
      query.avoided = wish.avoided;
      query.second = false;
      if (wish.from != core::kNoPlace) query.start = core::RouteEnd{wish.from, "", std::nullopt};
      if (wish.from == core::kNoPlace) {
        query.starts = {{static_cast<core::PlaceId>(1 + wish.unreachable.size()), 1.0}};
      }
      return memory().plan(query);
    };
    hooks.report = [](const core::Traversal& traversal) {
      require(traversal.from != traversal.to && traversal.begin <= traversal.end,
              "a way that nobody went");
    };
    return hooks;
  }

  core::RouteEnd end_;
  core::GoalRun run_;
  nanoseconds now_ = std::chrono::seconds(2000);
};

/// Goes about in a world that is whatever its sonars say.
class Wanderer {
 public:
  explicit Wanderer(const ExploreGoal& goal)
      : run_({memory(), feed_, parameters()}, goal.most_distance, goal.stay) {
    fix_.stamp = std::chrono::seconds(2000);
  }

  void run(core::ByteUnpacker& bytes) {
    for (int deeds = 0; bytes.left() > 0 && deeds < kMostDeeds && moves_ < kMostMoves; ++deeds) {
      act(bytes);
      check();
    }
  }

 private:
  static const config::Parameters& parameters() {
    static const config::Parameters parameters = config::loadParameters({});
    return parameters;
  }

  void act(core::ByteUnpacker& bytes) {
    switch (bytes.take<std::uint8_t>() % 5) {
      case 0:
        return move({0.02 * bytes.take<std::int8_t>(), 0.02 * bytes.take<std::int8_t>(),
                     0.02 * bytes.take<std::int8_t>()});
      case 1:
        return hear(bytes);
      case 2:
        return run_.arrived();
      case 3:
        return run_.blocked("a chair stands there");
      default:
        fix_.is_assumed = !fix_.is_assumed;
        feed_.setDoubt(0.05 * bytes.take<std::uint8_t>());
    }
  }

  void move(const core::Pose2d& motion) {
    ++moves_;
    fix_.stamp += milliseconds(400);
    fix_.odom_from_base = fix_.odom_from_base * motion;
    fix_.map_from_base = fix_.odom_from_base;
    run_.follow(fix_);
  }

  void hear(core::ByteUnpacker& bytes) {
    core::SonarReading reading;
    reading.sensor_pose = {0.1, 0.0, 0.025 * bytes.take<std::int8_t>()};
    reading.range = 0.02 * bytes.take<std::uint8_t>();
    reading.spec = {0.4, 0.0, 5.0};
    feed_.hear(fix_.odom_from_base, reading);
  }

  void check() const {
    require(run_.way() >= 0.0 && std::isfinite(run_.way()), "a way that is none");
    const auto spot = run_.spot();
    require(!spot || spot->isFinite(), "nowhere to go");
    for (const core::Explorer::Left& left : run_.left()) {
      require(left.spot.isFinite() && !left.why.empty(), "left out without a reason");
    }
  }

  node::SurveyFeed feed_;
  node::ExploreRun run_;
  node::RobotFix fix_;
  int moves_ = 0;
};

void go(const GoToPlaceGoal& goal, core::ByteUnpacker& bytes) {
  GoToPlaceResult result;
  const auto end = node::readGoal(goal, memory(), "map", result);
  if (end) return Goer(*end).run(bytes);
  require(result.status != GoToPlaceResult::REACHED, "refused, and reached");
  require(result.message.size() > 3 && result.message.size() < 200, "refused without a reason");
}

void explore(const ExploreGoal& goal, core::ByteUnpacker& bytes) {
  ExploreResult result;
  if (node::isTaken(goal, result)) return Wanderer(goal).run(bytes);
  require(result.status != ExploreResult::DONE && result.message.size() > 3,
          "refused without a reason");
}

template <class Goal>
bool read(const std::string& bytes, Goal& goal) {
  std::string copy = bytes;
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(copy.data()),
                                     static_cast<std::uint32_t>(copy.size()));
  try {
    ros::serialization::deserialize(stream, goal);
  } catch (const std::exception&) {  // roscpp's own, before anything of this package is called
    return false;
  }
  return true;
}

}  // namespace

// Of which of the two actions the goal is; its message; then what happens on the way.
void runGoals(const std::uint8_t* bytes, std::size_t size) {
  core::ByteUnpacker input(bytes, size);
  const bool explores = input.take<std::uint8_t>() % 2 == 1;
  const std::string message = input.takeText();
  GoToPlaceGoal to_place;
  ExploreGoal about;
  if (!explores && read(message, to_place)) go(to_place, input);
  if (explores && read(message, about)) explore(about, input);
}

}  // namespace place_memory::fuzz
