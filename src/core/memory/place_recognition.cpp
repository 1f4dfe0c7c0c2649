#include <map>
#include <utility>

#include "core/grid/grid_fusion.h"
#include "core/memory/link_pose.h"
#include "core/memory/place_memory_impl.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

/// Nothing where one of the places is gone.
std::optional<std::vector<std::string>> labelsOf(const std::vector<PlaceMatch>& matches,
                                                 const PlaceMap& map) {
  std::vector<std::string> labels;
  labels.reserve(matches.size());
  for (const PlaceMatch& match : matches) {
    const Place* place = map.find(match.id);
    if (place == nullptr) return std::nullopt;
    labels.push_back(place->label);
  }
  return labels;
}

bool liesAt(const Place& place, const PlaceFrame& frame) {
  return place.map_from_place == frame.map_from_place && place.session == frame.session;
}

/// Says where the robot is in the frame into which the place's session moves.
void moveWith(const SessionJoin& join, Recognition& recognition) {
  recognition.map_from_robot = join.into_from_from * recognition.map_from_robot;
  recognition.covariance = turned(recognition.covariance, join.into_from_from.yaw);
}

}  // namespace

std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& places,
                                                const PlaceMap& map) {
  std::vector<PlaceFrame> frames;
  frames.reserve(places.size());
  for (const PlaceId id : places) {
    const Place* place = map.find(id);
    if (place == nullptr) return std::nullopt;
    frames.push_back({place->map_from_place, place->session});
  }
  return frames;
}

PlaceMemory::Answer PlaceMemory::Impl::recognize(const Scan& scan,
                                                 std::optional<double> heading_window,
                                                 const std::function<bool()>& cancelled) {
  check(scan);
  const Tuning tuned = tuning();
  const double window = heading_window.value_or(tuned.options.heading_window);
  std::uint64_t question = 0;
  for (;;) {
    PlaceIndex snapshot;
    {
      const std::lock_guard<std::mutex> lock(state_.mutex);
      snapshot = state_.index;
      if (question == 0) question = state_.whereabouts.ask();
    }
    std::map<PlaceId, PlaceFrame> looked_up;
    const auto look_up = [&](const std::vector<PlaceId>& places) {
      auto frames = read([&](const MemoryState& state) { return framesOf(places, state.map); });
      for (std::size_t i = 0; frames && i < places.size(); ++i) {
        looked_up[places[i]] = (*frames)[i];
      }
      return frames;
    };
    auto found = tuned.recognizer->recognize(scan, snapshot, look_up, window, cancelled);
    if (!found) continue;
    Answer answer;
    answer.recognition = std::move(*found);
    std::optional<Following> following = settle(scan, question, looked_up, answer);
    if (!following) continue;
    following->sensed = sensedAt(scan, answer.recognition, tuned.adaptation);
    following->retention = tuned.adaptation.retention;
    if (changesMap(*following)) {
      try {
        queue_.run([&] { follow(*following, answer); });
      } catch (const PlaceMemoryError& error) {
        answer.adapt_problem = error.what();
      }
    }
    return answer;
  }
}

bool PlaceMemory::Impl::changesMap(const Following& following) {
  return following.sensed || following.settled.join || following.came;
}

std::optional<PlaceMemory::Impl::Following> PlaceMemory::Impl::settle(
    const Scan& scan, std::uint64_t question, const std::map<PlaceId, PlaceFrame>& frames,
    Answer& answer) {
  Recognition& recognition = answer.recognition;
  const std::lock_guard<std::mutex> lock(state_.mutex);
  // The verdict and the probabilities weighed every match, so one of a place that is gone by now
  // cannot just be left out.
  auto labels = labelsOf(recognition.matches, state_.map);
  if (!labels) return std::nullopt;
  answer.labels = std::move(*labels);
  Following following;
  following.scan_end = scan.end;
  if (recognition.verdict != Verdict::kRecognized) {
    answer.superseded = state_.whereabouts.notRecognized(question);
    answer.whereabouts = state_.whereabouts.now();
    return following;
  }
  const PlaceMatch& match = recognition.matches.front();
  const Place& place = *state_.map.find(match.id);
  if (!liesAt(place, frames.at(match.id))) return std::nullopt;
  following.place = place.id;
  following.settled = state_.whereabouts.recognized(
      question, {place, match.place_from_scan, scan.odom_from_scan,
                 turned(recognition.covariance, -place.map_from_place.yaw)});
  answer.superseded = following.settled.superseded;
  if (!answer.superseded) {
    const PlaceId from = following.settled.came_from;
    if (from != kNoPlace && from != place.id) following.came = wayTo(scan, from, place.id);
    stood_ = {place.id, scan.end};
  }
  answer.whereabouts = state_.whereabouts.now();
  const auto& join = following.settled.join;
  if (join && join->from == place.session) moveWith(*join, recognition);
  return following;
}

std::optional<EvidenceGrid> PlaceMemory::Impl::sensedAt(const Scan& scan,
                                                        const Recognition& recognition,
                                                        const AdaptationOptions& adaptation) const {
  if (!adaptation.enabled || recognition.verdict != Verdict::kRecognized) return std::nullopt;
  return sonar_.build(movedReadings(scan.readings, recognition.matches.front().place_from_scan),
                      GridGeometry{cell_size_});
}

void PlaceMemory::Impl::follow(const Following& following, Answer& answer) {
  std::vector<MapEdit> edits;
  std::size_t joined = 0;
  if (following.settled.join) joined = join(*following.settled.join, edits);
  traverse(following, edits);
  const bool folds = fold(following, edits);
  writer_.commit(std::move(edits));
  answer.joined = joined;
  answer.adapted = folds;
  if (folds) last_folded_ = following.scan_end;
}

std::size_t PlaceMemory::Impl::join(const SessionJoin& join, std::vector<MapEdit>& edits) const {
  const std::size_t before = edits.size();
  for (const Place& place : state_.map.places()) {
    if (place.session != join.from) continue;
    edits.emplace_back(PlaceMoved{place.id, join.into_from_from * place.map_from_place, join.into});
  }
  return edits.size() - before;
}

void PlaceMemory::Impl::traverse(const Following& following, std::vector<MapEdit>& edits) {
  // Who drives here tells of each link by itself, and of a way round too.
  const bool is_told = following.came && reported_to_ == following.came->to;
  reported_to_ = kNoPlace;
  if (!following.came || is_told) return;
  if (auto learned = learnedBy(*following.came)) edits.emplace_back(std::move(*learned));
}

bool PlaceMemory::Impl::fold(const Following& following, std::vector<MapEdit>& edits) {
  const Place* place = state_.map.find(following.place);
  // Evidence that is already in the grid is no further evidence.
  if (!following.sensed || place == nullptr || place->learned == following.scan_end ||
      last_folded_ == following.scan_end) {
    return false;
  }
  const auto grid = std::make_shared<EvidenceGrid>(
      writer_.query([&](PlaceStore& store) { return store.grid(following.place); }));
  fuse(*following.sensed, following.retention, *grid);
  edits.emplace_back(GridAdapted{following.place, grid});
  return true;
}

}  // namespace place_memory::core
