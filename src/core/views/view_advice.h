#ifndef PLACE_MEMORY_CORE_VIEWS_VIEW_ADVICE_H
#define PLACE_MEMORY_CORE_VIEWS_VIEW_ADVICE_H

#include <cstddef>
#include <optional>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Where the robot may be now.
struct PoseCandidate {
  PlaceId place = kNoPlace;  ///< that says so
  Pose2d map_from_base;      ///< in the frame of the place's session
  double probability = 0.0;  ///< >= 0
  SessionId session = kFirstSession;
};

/// What the robot has heard from about where it is.
struct SeenGrid {
  EvidenceGrid grid;
  Pose2d grid_from_base;  ///< where it is now
};

/// Asked while it is not sure where the robot is.
struct ViewQuestion {
  std::vector<PoseCandidate> candidates;  ///< in any order
  std::optional<SeenGrid> seen;           ///< nothing: on the spot it has seen everything
  double turn_rate = 0.6;                 ///< of the robot [rad/s], > 0
  double sure = 0.9;                      ///< from this probability on no view is needed
};

/// What to look at next, so that it becomes clear which candidate is the true one.
struct View {
  enum class Kind {
    kTurn,   ///< turn on the spot, and look there
    kDrive,  ///< drive along links, and look about there
  };
  Kind kind = Kind::kTurn;
  double bearing = 0.0;         ///< from where the robot looks now [rad], in [-pi, pi)
  std::vector<Pose2d> spots;    ///< to be driven to straight, in the base's frame as it is now
  std::vector<PlaceId> places;  ///< of the links, by candidate `by`: the first is where that is
  std::size_t by = 0;           ///< index of the candidate from whose map the way is
  double time = 0.0;            ///< that it takes, expected [s]
  double information = 0.0;     ///< expected [bit]
  double probability = 0.0;     ///< of the likeliest candidate afterwards, expected
};

struct ViewAdvice {
  enum class Status {
    kFound,
    kSure,          ///< no view is needed
    kNoView,        ///< none that can be reached parts the candidates
    kNoCandidates,  ///< nothing speaks for any place
  };
  Status status = Status::kNoCandidates;
  std::optional<View> view;  ///< with kFound
  std::vector<PoseCandidate>
      candidates;         ///< that were compared, the likeliest first; they sum to 1
  std::size_t views = 0;  ///< that were compared
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VIEWS_VIEW_ADVICE_H
