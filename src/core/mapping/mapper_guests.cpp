// What a drive takes from others than its own sensors: scans of a robot that stood, and what a
// person says of places and of where the robot is.
#include <algorithm>
#include <set>

#include "core/mapping/mapper.h"

namespace place_memory::core {
namespace {

constexpr double kLostByWord = 0.05;      ///< after a person said where the robot is
constexpr double kStandingStretch = 1.0;  ///< as so long a stretch a scan of one spot counts [m]
constexpr double kToldRegion = 1.0;       ///< a place so near to a told pose is believed in [m]

}  // namespace

std::optional<Pose2d> Mapper::sessionFromOdom() const {
  Pose2d session_from_base;
  if (told_) {
    session_from_base = told_->map_from_base * (told_->reckoned.inverse() * reckoning_.pose());
  } else if (last_middle_) {
    session_from_base =
        graph_.nodes().back().pose * (last_middle_->reckoned.inverse() * reckoning_.pose());
  } else {
    return std::nullopt;
  }
  return session_from_base * newest_odom_.inverse();
}

void Mapper::setPose(const Pose2d& map_from_base) {
  beginSession();
  addOdometry({}, newest_odom_);  // it goes on, only what it was about is no more believed
  session_ = kMapSession;
  told_ = ToldPose{map_from_base, reckoning_.pose()};
  is_told_ = true;
  anchored_way_ = reckoning_.way();
  lost_.set(kLostByWord);
  belief_.reset();
  for (const PlaceShelf::Near& near : shelf_.near(map_from_base, kMapSession, kToldRegion, true)) {
    belief_.setTo(near.id, graph_.node(shelf_.nodeOf(near.id)).pose.inverse() * map_from_base);
    break;
  }
}

void Mapper::addStanding(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base,
                         std::vector<SonarReading> readings) {
  if (readings.empty()) return;
  addOdometry(stamp, odom_from_base);
  // The next stretch begins here, so that it shares no reading with this scan.
  builder_.restart();
  MovingScan scan;
  scan.middle = {stamp, odom_from_base, reckoning_.pose(), reckoning_.way(), reckoning_.turn()};
  scan.first_way = reckoning_.way() - kStandingStretch;
  scan.last_way = reckoning_.way();
  scan.readings = std::make_shared<const std::vector<SonarReading>>(std::move(readings));
  standing_ = true;
  process(scan);
  standing_ = false;
}

void Mapper::adopt(PlaceId id, std::chrono::nanoseconds stamp) {
  const auto& nodes = graph_.nodes();
  const auto found = std::find_if(nodes.rbegin(), nodes.rend(),
                                  [stamp](const ScanNode& node) { return node.stamp == stamp; });
  if (found == nodes.rend() || found->place != kNoPlace || !found->readings) return;
  const auto at = static_cast<NodeIndex>(std::distance(found, nodes.rend()) - 1);
  const ScanNode& node = graph_.node(at);
  std::vector<PlaceId> doubled;
  for (const PlaceShelf::Near& near :
       shelf_.near(node.pose, node.session, options_.doubled, false)) {
    if (named_.count(near.id) == 0) doubled.push_back(near.id);
  }
  for (const PlaceId other : doubled) forget(other);
  shelf_.add(at, graph_, id);
  named_.insert(id);
}

void Mapper::forget(PlaceId id) {
  named_.erase(id);
  if (!shelf_.has(id)) return;
  shelf_.remove(id, graph_);
  belief_.forget(id);
}

ClosureWord Mapper::confirmClosure(PlaceId place) {
  const bool is_known = loops_.at(place) || carried_.at(place) || joins_.at(place);
  if (!is_known || !last_middle_) return ClosureWord::kNoQuestion;
  // Odometry cannot have brought it there: what it was about lies apart, and then joins the map.
  if (carried_.at(place)) partWays();
  const bool is_apart = session_ != kMapSession;
  const ClosureCandidate* join = is_apart ? joins_.at(place) : nullptr;
  const ClosureCandidate* candidate = join ? join : loops_.at(place);
  if (!candidate) return ClosureWord::kRefused;
  return close(*candidate, join ? kMapSession : session_, last_middle_->way)
             ? ClosureWord::kDone
             : ClosureWord::kRefused;
}

ClosureWord Mapper::cutClosure(PlaceId place) {
  bool any = false;
  for (ClosureCandidates* kind : {&loops_, &carried_, &joins_}) any = kind->cut(place) || any;
  if (any) return ClosureWord::kDone;
  if (!closer_.cutTrial(place)) return ClosureWord::kNoQuestion;
  takeBack();
  return ClosureWord::kDone;
}

void Mapper::note(MapperEvent::Kind kind, const ClosureCandidate* candidate) {
  std::set<PlaceId> places;
  if (candidate != nullptr) {
    for (const Witness& witness : candidate->witnesses) places.insert(witness.place);
  }
  events_.push_back({kind, graph_.nodes().back().stamp, {places.begin(), places.end()}});
}

std::vector<MapperEvent> Mapper::takeEvents() {
  std::vector<MapperEvent> taken;
  taken.swap(events_);
  return taken;
}

}  // namespace place_memory::core
