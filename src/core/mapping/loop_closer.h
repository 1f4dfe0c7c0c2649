#ifndef PLACE_MEMORY_CORE_MAPPING_LOOP_CLOSER_H
#define PLACE_MEMORY_CORE_MAPPING_LOOP_CLOSER_H

#include <map>
#include <optional>
#include <vector>

#include "core/mapping/closure_candidates.h"
#include "core/mapping/place_shelf.h"
#include "core/mapping/scan_graph.h"
#include "core/mapping/scan_tying.h"

namespace place_memory::core {

/// Closes loops and joins sessions, and takes that back where the map speaks against it: at once
/// where older ties suffer, within some metres where the robot does not find what it should see,
/// and later where new closures contradict it.
class LoopCloser {
 public:
  /// Keeps references.
  LoopCloser(ScanGraph& graph, PlaceShelf& shelf, ScanTying& tying)
      : graph_(graph), shelf_(shelf), tying_(tying) {}

  /// Within a session, or where `target` is another one, of a session with that. `moves_map`: the
  /// whole map is relaxed; otherwise only the robot's newest way. False where it was refused.
  bool close(const ClosureCandidate& candidate, int session, int target, bool moves_map,
             double way);

  /// What the scan after it showed: whether it was tracked, and whether it should have been, since
  /// a place is there. True where the newest closure is taken back for that.
  bool observe(bool tracked, bool expected, double way);

  /// The closure that is on trial, 0: none. Ties that rest on it go with it.
  int onTrial() const { return trial_ ? trial_->number : 0; }
  /// A person says that the closure on trial is wrong; false where none that is ties scans to the
  /// place.
  bool cutTrial(PlaceId place);
  /// The robot is elsewhere: what is on trial is neither proven nor disproven.
  void endTrial() { trial_.reset(); }
  /// Of a trial that failed: the session that is apart again, where sessions had been joined.
  std::optional<int> splitSession() const { return split_; }
  /// Cuts closures whose ties are far off by now; whether there were any.
  bool cutContradicted();

 private:
  struct Trial {
    int number;
    double way;                  ///< at which it was closed [m]
    std::optional<int> joined;   ///< session that it joined to the map
    NodeIndex first_joined = 0;  ///< its first node
    Pose2d target_from_session;
    int hits = 0;
    int misses = 0;
  };

  void tieWitnesses(const ClosureCandidate& candidate, bool joins, int number);
  bool holds(int number, double old_chi);
  void takeBack(const Trial& trial);

  ScanGraph& graph_;
  PlaceShelf& shelf_;
  ScanTying& tying_;
  std::optional<Trial> trial_;
  std::optional<int> split_;
  int closures_ = 0;
  std::map<int, int> contradicted_;  ///< closures, by how many later ones spoke against them
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_LOOP_CLOSER_H
