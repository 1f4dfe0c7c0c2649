#include "core/views/view_adviser.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/views/pose_candidates.h"

namespace place_memory::core {
namespace {

constexpr double kLook = 5.0;              // that looking about takes [s]
constexpr double kAtPlace = 1.0;           // so near to a spot a place tells how it looks [m]
constexpr double kElsewhere = 1.0;         // what is nearer than this has been seen [m]
constexpr double kSameSpot = 0.5;          // of two views so near one is enough [m]
constexpr double kLeastInformation = 0.1;  // [bit]

double lengthOf(const Pose2d& pose) { return std::hypot(pose.x, pose.y); }

/// The views of one question.
class Comparison {
 public:
  Comparison(const ViewAdviser::Grids& grids, std::vector<PoseCandidate> candidates,
             std::vector<std::vector<ViewPoint>> reached)
      : grids_(grids), candidates_(std::move(candidates)), reached_(std::move(reached)) {
    for (const PoseCandidate& candidate : candidates_) {
      probabilities_.push_back(candidate.probability);
    }
    entropy_ = entropyOf(probabilities_);
  }

  void addTurns(const SeenGrid& seen, double turn_rate) {
    const Bearings known = knownOf(expectedView(seen.grid, seen.grid_from_base));
    for (std::size_t i = 0; i < kViewBearings; ++i) {
      Bearings counted = sectorAbout(i);
      for (std::size_t k = 0; k < kViewBearings; ++k) counted[k] = counted[k] && !known[k];
      if (std::none_of(counted.begin(), counted.end(), [](bool counts) { return counts; }))
        continue;
      View view;
      view.bearing = bearingOf(i);
      view.time = std::abs(view.bearing) / turn_rate;
      offer(std::move(view), {}, counted);
    }
  }

  void addDrives() {
    std::vector<View> drives;
    for (std::size_t by = 0; by < candidates_.size(); ++by) {
      const Pose2d base_from_map = candidates_[by].map_from_base.inverse();
      for (const ViewPoint& point : reached_[by]) {
        const Pose2d spot = spotOf(base_from_map * point.map_from_place);
        const bool is_known = std::any_of(drives.begin(), drives.end(), [&](const View& other) {
          return lengthOf(other.spots.back().inverse() * spot) < kSameSpot;
        });
        if (lengthOf(spot) < kElsewhere || is_known) continue;
        drives.push_back(driveTo(point, by));
      }
    }
    std::stable_sort(drives.begin(), drives.end(),
                     [](const View& one, const View& other) { return one.time < other.time; });
    Bearings all{};
    all.fill(true);
    for (View& view : drives) {
      // No view tells more than all there is to know.
      if (best_ && entropy_ / (view.time + kLook) <= rateOf(*best_)) return;
      const Pose2d spot = view.spots.back();
      offer(std::move(view), spot, all);
    }
  }

  ViewAdvice advice() const {
    ViewAdvice advice;
    advice.status = best_ ? ViewAdvice::Status::kFound : ViewAdvice::Status::kNoView;
    advice.view = best_;
    advice.candidates = candidates_;
    advice.views = views_;
    return advice;
  }

 private:
  static Pose2d spotOf(const Pose2d& pose) { return {pose.x, pose.y, 0.0}; }
  static double rateOf(const View& view) { return view.information / (view.time + kLook); }

  View driveTo(const ViewPoint& point, std::size_t by) const {
    const Pose2d base_from_map = candidates_[by].map_from_base.inverse();
    View view;
    view.kind = View::Kind::kDrive;
    view.by = by;
    view.time = expectedTime(spotOf(base_from_map * point.map_from_place));
    for (const ViewPoint* at = &point; at != nullptr; at = find(by, at->before)) {
      view.places.insert(view.places.begin(), at->place);
      // Where the way begins the robot is.
      if (at->before != kNoPlace || view.spots.empty()) {
        view.spots.insert(view.spots.begin(), spotOf(base_from_map * at->map_from_place));
      }
    }
    view.bearing = wrapAngle(std::atan2(view.spots.front().y, view.spots.front().x));
    return view;
  }

  const ViewPoint* find(std::size_t candidate, PlaceId place) const {
    for (const ViewPoint& point : reached_[candidate]) {
      if (place != kNoPlace && point.place == place) return &point;
    }
    return nullptr;
  }

  /// Where a candidate is the true one, the place at the spot; nullptr: there is none.
  const ViewPoint* pointAt(std::size_t candidate, const Pose2d& spot) const {
    const Pose2d there = candidates_[candidate].map_from_base * spot;
    const ViewPoint* nearest = nullptr;
    double least = kAtPlace;
    for (const ViewPoint& point : reached_[candidate]) {
      const double distance =
          std::hypot(point.map_from_place.x - there.x, point.map_from_place.y - there.y);
      if (distance > least) continue;
      least = distance;
      nearest = &point;
    }
    return nearest;
  }

  /// Over the candidates that know the spot.
  double expectedTime(const Pose2d& spot) const {
    double time = 0.0, all = 0.0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ViewPoint* point = pointAt(i, spot);
      if (point == nullptr) continue;
      time += probabilities_[i] * point->time;
      all += probabilities_[i];
    }
    return all > 0.0 ? time / all : 0.0;
  }

  /// What would be seen from the spot if a candidate were the true one.
  struct Sight {
    std::vector<ExpectedView> about;  ///< as viewsAbout() has them; empty: it cannot be predicted
  };

  std::vector<Sight> sightsFrom(const Pose2d& spot) {
    std::vector<Sight> sights(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ViewPoint* point = pointAt(i, spot);
      if (point == nullptr) continue;
      const std::shared_ptr<const EvidenceGrid>& grid = gridOf(point->place);
      if (!grid) continue;
      sights[i].about =
          viewsAbout(*grid, point->map_from_place.inverse() * candidates_[i].map_from_base * spot);
    }
    return sights;
  }

  const std::shared_ptr<const EvidenceGrid>& gridOf(PlaceId place) {
    const auto found = loaded_.find(place);
    return found != loaded_.end() ? found->second : loaded_[place] = grids_(place);
  }

  std::vector<std::vector<double>> likelihoodsOf(const std::vector<Sight>& sights,
                                                 const Bearings& counted) const {
    const std::size_t count = sights.size();
    std::vector<std::vector<double>> likelihoods(count, std::vector<double>(count, 1.0));
    for (std::size_t i = 0; i < count; ++i) {
      if (sights[i].about.empty()) continue;
      double sum = 0.0, weight = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        if (sights[k].about.empty()) continue;
        likelihoods[i][k] = likeness(sights[i].about.front(), sights[k].about, counted);
        sum += probabilities_[k] * likelihoods[i][k];
        weight += probabilities_[k];
      }
      // What is seen speaks neither for nor against what cannot be predicted.
      for (std::size_t k = 0; k < count; ++k) {
        if (sights[k].about.empty()) likelihoods[i][k] = sum / weight;
      }
    }
    return likelihoods;
  }

  void offer(View view, const Pose2d& spot, const Bearings& counted) {
    ++views_;
    const ExpectedAnswer answer =
        expectedAnswer(probabilities_, likelihoodsOf(sightsFrom(spot), counted));
    view.information = answer.information;
    view.probability = answer.probability;
    if (view.information < kLeastInformation) return;
    if (!best_ || rateOf(view) > rateOf(*best_)) best_ = std::move(view);
  }

  const ViewAdviser::Grids& grids_;
  const std::vector<PoseCandidate> candidates_;
  const std::vector<std::vector<ViewPoint>> reached_;  // by candidate
  std::vector<double> probabilities_;
  double entropy_ = 0.0;
  std::map<PlaceId, std::shared_ptr<const EvidenceGrid>> loaded_;
  std::optional<View> best_;
  std::size_t views_ = 0;
};

}  // namespace

ViewAdvice ViewAdviser::advise(const ViewQuestion& question) const {
  ViewAdvice advice;
  advice.candidates = mergedCandidates(question.candidates);
  if (advice.candidates.empty()) return advice;
  if (advice.candidates.front().probability >= question.sure) {
    advice.status = ViewAdvice::Status::kSure;
    return advice;
  }
  std::vector<std::vector<ViewPoint>> reached;
  for (const PoseCandidate& candidate : advice.candidates) reached.push_back(reach_(candidate));
  Comparison comparison(grids_, advice.candidates, std::move(reached));
  if (question.seen) comparison.addTurns(*question.seen, question.turn_rate);
  comparison.addDrives();
  return comparison.advice();
}

}  // namespace place_memory::core
