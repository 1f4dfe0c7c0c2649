#ifndef PLACE_MEMORY_CORE_PLACE_MEMORY_H
#define PLACE_MEMORY_CORE_PLACE_MEMORY_H

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/grid/grid_fusion.h"
#include "core/index/place_index.h"
#include "core/recognize/recognizer.h"
#include "core/store/place_store.h"
#include "place_memory/core/place_graph.h"
#include "place_memory/core/recognition.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// Why the memory refused what it was asked for; what() says it in a sentence.
class PlaceMemoryError : public std::runtime_error {
 public:
  enum class Reason {
    kLabelTaken,
    kInvalidLabel,
    kUnknownPlace,
    kInvalidScan,  ///< cells of another size than the store's, or a pose that is not finite
    kStoreFailed,  ///< the store could not be read or written; the memory is as it was
  };

  PlaceMemoryError(Reason reason, const std::string& what)
      : std::runtime_error(what), reason_(reason) {}

  Reason reason() const { return reason_; }

 private:
  Reason reason_;
};

struct PlaceMemoryOptions {
  std::string store_path;               ///< file of the places; "": in memory only
  StoreOpening opening;                 ///< of that file
  double cell_size = kDefaultCellSize;  ///< of all grids [m], > 0
  RecognizerOptions recognizer;
  AdaptationOptions adaptation;
  SonarModelOptions sonar;  ///< with which scans that places follow are laid into their grids
};

/// A recognition with the labels of its matches, in their order.
struct LabelledRecognition {
  Recognition recognition;
  std::vector<std::string> labels;
  /// Since it was asked for, the robot learned or recognized a newer scan, or was carried: it does
  /// not say where the robot is now.
  bool superseded = false;
};

/// Learns places, recognizes them, and keeps them in the topological/metric map (paper 3, 4).
///
/// Thread-safe. Matching works on a snapshot, so that no other call waits for it.
class PlaceMemory {
 public:
  /// Opens the store. Throws StoreError, and std::invalid_argument naming an option out of range.
  explicit PlaceMemory(const PlaceMemoryOptions& options);

  /// Makes the scan a place, linked to the previous one (paper 7). `label` "": one is made up.
  /// Throws PlaceMemoryError.
  Place learn(const Scan& scan, const std::string& label);

  /// Matches the scan against every place. Arguments and errors are those of
  /// Recognizer::recognize(). A place that is removed during the match is not among the matches.
  LabelledRecognition recognize(const Scan& scan, double heading_window,
                                const std::function<bool()>& cancelled = nullptr);

  /// Where places adapt, folds the scan, of which `recognition` is the answer, into the grid of the
  /// place; the place's location stays. Nothing happens unless the verdict is RECOGNIZED, nor where
  /// the place is gone by now, nor with the scan that it was learned from or that was folded last.
  /// Returns whether it was folded. Throws PlaceMemoryError; the place is then as it was.
  bool adapt(const Scan& scan, const Recognition& recognition);

  /// Throws PlaceMemoryError.
  void rename(const std::string& label, const std::string& new_label);
  /// Removes the place and its links. Throws PlaceMemoryError.
  void remove(const std::string& label);
  /// Removes every place and returns how many there were. Throws PlaceMemoryError.
  std::size_t clear();

  /// Number of places.
  std::size_t size() const;
  /// The map as it is now.
  PlaceGraph graph() const;
  std::optional<Place> place(PlaceId id) const;
  /// The grid as it was learned, and adapted since. Throws PlaceMemoryError.
  EvidenceGrid grid(PlaceId id) const;

  /// The place that was last learned or last recognized, which the next one is linked to.
  std::optional<Place> previousPlace() const;
  /// The next place that is learned is linked to none: the robot was carried, or time ran
  /// backwards.
  void forgetPreviousPlace();

 private:
  /// Nothing where one of the places is gone.
  std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& places) const;
  const Place& findLocked(const std::string& label) const;
  std::string newLabelLocked(const std::string& wanted) const;
  std::optional<std::vector<std::string>> labelsLocked(
      const std::vector<PlaceMatch>& matches) const;

  const double cell_size_;
  const Recognizer recognizer_;
  const AdaptationOptions adaptation_;
  const SonarModel sonar_;

  mutable std::mutex mutex_;  ///< guards everything below
  PlaceStore store_;
  PlaceGraph graph_;
  PlaceIndex index_;
  PlaceId previous_ = kNoPlace;
  std::uint64_t questions_ = 0;      ///< that were asked about where the robot is
  std::uint64_t newest_answer_ = 0;  ///< the one of them that is answered
  std::optional<std::chrono::nanoseconds> last_folded_;  ///< when that scan ended
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_MEMORY_H
