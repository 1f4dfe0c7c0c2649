#ifndef PLACE_MEMORY_CORE_VIEWS_VIEW_ADVISER_H
#define PLACE_MEMORY_CORE_VIEWS_VIEW_ADVISER_H

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/views/expected_answer.h"
#include "core/views/expected_view.h"
#include "core/views/view_advice.h"

namespace place_memory::core {

/// A place that the robot can drive to if a candidate is the true one.
struct ViewPoint {
  PlaceId place = kNoPlace;
  PlaceId before = kNoPlace;  ///< on the way there; kNoPlace: the way begins at this one
  Pose2d map_from_place;
  double time = 0.0;  ///< expected [s]
};

/// Says what a robot should look at next that may be at several places (ELDEN asks the world back):
/// for each candidate it predicts, by the grids of places, what would be heard from each view, and
/// takes the view that tells the most, per second that it takes, of which one is true. What lies
/// where no place is cannot be predicted, and tells nothing.
class ViewAdviser {
 public:
  /// Of a place; nullptr: it is gone.
  using Grids = std::function<std::shared_ptr<const EvidenceGrid>(PlaceId)>;
  /// What can be reached from where a candidate is, the quickest to reach first.
  using Reach = std::function<std::vector<ViewPoint>(const PoseCandidate&)>;

  ViewAdviser(Grids grids, Reach reach) : grids_(std::move(grids)), reach_(std::move(reach)) {}

  ViewAdvice advise(const ViewQuestion& question) const;

 private:
  Grids grids_;
  Reach reach_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VIEWS_VIEW_ADVISER_H
