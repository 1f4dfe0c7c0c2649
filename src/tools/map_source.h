#ifndef PLACE_MEMORY_TOOLS_MAP_SOURCE_H
#define PLACE_MEMORY_TOOLS_MAP_SOURCE_H

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::tools {

/// Exit statuses of place_memory.
enum ExitStatus {
  kDone = 0,
  kFailed = 1,   ///< arguments, file or folder are not such that it could be done
  kNo = 2,       ///< it was done, and the answer is no: not recognized, no route, damaged, nothing
  kNoAnswer = 3  ///< the node is not there, or does not answer
};

/// Why a command cannot be done, and with which status the program ends.
class CommandError : public std::runtime_error {
 public:
  explicit CommandError(const std::string& what, ExitStatus status = kFailed)
      : std::runtime_error(what), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// Which scan is learned or recognized.
struct ScanChoice {
  std::string place;        ///< of a store: the scan that this place was learned from
  std::string other_store;  ///< in which that place is; empty: in the same
  bool scan_now = false;    ///< of a node: it scans first; otherwise its newest scan
};

/// What came of recognizing.
struct Recognized {
  struct Match {
    std::string label;
    double probability = 0.0;
    double score = 0.0;
    core::Pose2d place_from_scan;
  };

  std::string verdict;
  std::string message;
  core::Pose2d map_from_robot;  ///< by the best match
  std::vector<Match> matches;
};

/// A way from place to place.
struct PlannedRoute {
  std::string problem;              ///< why there is none; empty: there is one
  std::vector<std::string> labels;  ///< from the start to the goal
  double cost = 0.0;                ///< expected time until the robot is there [s]
  double odds = 1.0;                ///< of getting through at the first attempt
};

/// Is told what happens, in a sentence each.
using Progress = std::function<void(const std::string&)>;

/// What became of driving to a place.
struct DrivenGoal {
  enum class End {
    kReached,
    kNoWay,  ///< none leads there, or there is no such place
    kFailed,
  };
  End end = End::kFailed;
  std::string message;  ///< where the robot is, or why it is not there
};

/// A map, be it in a file or in a node that runs. What fails throws CommandError, or another
/// std::exception that says why.
class MapSource {
 public:
  MapSource() = default;
  MapSource(const MapSource&) = delete;
  MapSource& operator=(const MapSource&) = delete;
  virtual ~MapSource() = default;

  virtual core::MapSnapshot map() = 0;
  virtual core::EvidenceGrid grid(core::PlaceId id) = 0;
  /// These return what was done, in a sentence.
  virtual std::string learn(const std::string& label, const ScanChoice& scan) = 0;
  virtual std::string exportTo(const std::string& folder) = 0;
  /// A sentence for each label that was taken is added to `collisions`.
  virtual std::string merge(const std::string& path, std::vector<std::string>& collisions) = 0;
  virtual PlannedRoute plan(const std::string& from, const std::string& to) = 0;
  virtual Recognized recognize(const ScanChoice& scan) = 0;
  /// Has the robot drive there, and waits until that is over.
  virtual DrivenGoal go(const std::string& label, const Progress& progress) = 0;
  virtual std::vector<core::PastChange> history(std::size_t count) = 0;
  virtual std::vector<core::PastChange> undo(std::size_t count) = 0;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_MAP_SOURCE_H
