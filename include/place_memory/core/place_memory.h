#ifndef PLACE_MEMORY_CORE_PLACE_MEMORY_H
#define PLACE_MEMORY_CORE_PLACE_MEMORY_H

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/adaptation_options.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/recognition.h"
#include "place_memory/core/recognizer_options.h"
#include "place_memory/core/routes.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"
#include "place_memory/core/store_opening.h"
#include "place_memory/core/whereabouts.h"
#include "place_memory/export.h"

namespace place_memory::core {

struct KeptMap;

/// Why the memory refused what it was asked for; what() says it in a sentence.
class PLACE_MEMORY_PUBLIC PlaceMemoryError : public std::runtime_error {
 public:
  enum class Reason {
    kLabelTaken,
    kInvalidLabel,
    kUnknownPlace,
    kInvalidScan,       ///< a pose that is not finite
    kWrongCells,        ///< cells of another size than the map's
    kAlreadyLearned,    ///< this very scan is a place already
    kDoubtfulScan,      ///< something speaks against the scan (Scan::doubt)
    kStoreFailed,       ///< the store could not be read or written; the memory is as it was
    kNoEcho,            ///< no echo lies in the scan's grid: nothing could be recognized by it
    kUnknownLink,       ///< the two places are not linked
    kInvalidTraversal,  ///< ends before it begins or after now, a toll below 0, a source of no text
    kOtherStore,        ///< another store's file could not be read; the memory is as it was
    kNothingToUndo,     ///< the history is shorter than that
    kCannotUndo,        ///< the map has changed since, or what was there was too much to be kept
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
  LinkLearningOptions links;
  SonarModelOptions sonar;  ///< with which scans that places follow are laid into their grids
  /// Tells the time that changes are stamped with; null: the system's clock.
  std::function<std::chrono::nanoseconds()> clock;
};

/// The map at one moment.
struct MapSnapshot {
  std::uint64_t version = 0;
  std::chrono::nanoseconds stamp{0};  ///< of the newest change
  std::vector<Place> places;          ///< by rising id
  std::vector<PlaceLink> links;       ///< by rising first id, then by rising second id
};

/// Whether changes can be kept.
struct StoreHealth {
  bool ok = true;
  std::string problem;  ///< why the newest change that was tried could not be kept, in a sentence
  std::chrono::nanoseconds since{0};  ///< when it became so, by PlaceMemoryOptions::clock
  /// What is damaged in the store and left out, a sentence each.
  std::vector<std::string> set_aside;
};

/// What came of taking in the places of another store.
struct MergeReport {
  /// A label that a place of the map had already, and what the new place is called instead.
  struct Collision {
    std::string label;
    std::string new_label;
  };

  std::size_t added = 0;   ///< places
  std::size_t known = 0;   ///< places that were in the map already, by identity or recognition
  std::size_t joined = 0;  ///< sessions of the other store that lie in a frame of the map now
  std::size_t apart = 0;   ///< sessions whose frame is not known: they are sessions of their own
  std::vector<Collision> collisions;
};

/// Learns places, recognizes them, and keeps them in the topological/metric map (paper 3, 4).
///
/// Thread-safe. Changes are made one after the other on a thread of the memory's, each in the
/// store, the map and the index or in none of them; who asks for one waits until it is kept. Nobody
/// else waits for the disk or for a match.
class PLACE_MEMORY_PUBLIC PlaceMemory {
 public:
  /// What came of learning a place.
  struct Learned {
    Place place;
    /// It belongs to a session of its own, because where the robot is in the map was not known.
    bool apart = false;
    std::string message;  ///< says so, and what to do, in a sentence; "" where it is not apart
  };

  /// What came of recognizing a scan.
  struct Answer {
    Recognition recognition;
    std::vector<std::string> labels;  ///< of the matches, in their order
    /// Since it was asked for, the robot learned or recognized a newer scan, or was carried: it
    /// does not say where the robot is now.
    bool superseded = false;
    Whereabouts whereabouts;    ///< right after this answer
    bool adapted = false;       ///< the scan was folded into the place's grid
    std::size_t joined = 0;     ///< places that moved, because two sessions were joined
    std::string adapt_problem;  ///< why the map could not follow (adapted, joined); "": it could
  };

  /// Opens the store. Throws StoreError, and std::invalid_argument naming an option out of range.
  explicit PlaceMemory(const PlaceMemoryOptions& options);
  /// Changes that were asked for are made first.
  ~PlaceMemory();
  PlaceMemory(const PlaceMemory&) = delete;
  PlaceMemory& operator=(const PlaceMemory&) = delete;

  /// Makes the scan a place, linked to the previous one (paper 7). `label` "": one is made up.
  /// Without `force` a scan in whose grid no echo lies is refused. Throws PlaceMemoryError.
  Learned learn(const Scan& scan, const std::string& label, bool force = false);

  /// The one way from a scan to an answer: matches it against every place (a place that is removed
  /// meanwhile is not among the matches), settles where the robot is, folds the scan into the place
  /// where it is RECOGNIZED and places adapt, and tells the listeners. A scan is folded into a
  /// place once, and never into the one that was learned from it; the place's location stays.
  ///
  /// `heading_window` is how far the compass may be off, in [0, pi] [rad]; pi stands for any
  /// heading, and none for RecognizerOptions::heading_window. `cancelled`, where given, is polled
  /// between blocks of places; once it returns true the call throws std::runtime_error. Throws
  /// std::invalid_argument where the window is out of range, and PlaceMemoryError (kWrongCells,
  /// kInvalidScan).
  Answer recognize(const Scan& scan, std::optional<double> heading_window,
                   const std::function<bool()>& cancelled = nullptr);

  /// Scans are recognized, and folded into places, by these options from the next call of
  /// recognize() on; one that is under way keeps those it began with. Whether odometry locates
  /// places stays as it was at the start. Throws std::invalid_argument naming an option out of
  /// range, and then all stays as it is.
  void setOptions(const RecognizerOptions& recognizer, const AdaptationOptions& adaptation);

  /// Throws PlaceMemoryError.
  void rename(const std::string& label, const std::string& new_label);
  /// Removes the place and its links. Throws PlaceMemoryError.
  void remove(const std::string& label);
  /// Removes every place and returns how many there were. Throws PlaceMemoryError.
  std::size_t clear();

  /// Writes a store's file with all that is known: a sound copy, whatever happens meanwhile. A
  /// store that has the name already goes. Throws PlaceMemoryError (kStoreFailed).
  void save(const std::string& path) const;
  /// Puts the places of another store into the place of those that are known, and returns how many
  /// there are. They get new ids; labels and identities stay. Where the robot is is not known then.
  /// The scans between places that a drive left in that store are not among them. Throws
  /// PlaceMemoryError (kOtherStore, kStoreFailed).
  std::size_t load(const std::string& path);
  /// Takes in the places of another store, of this robot or of another one. A session of it lies
  /// where most of its places are that are recognized, or known by identity; one of which too few
  /// are stays a session of its own. Throws PlaceMemoryError (kOtherStore, kStoreFailed).
  MergeReport merge(const std::string& path);

  /// The newest changes that can be taken back, newest first, no more than `most`. Counting the
  /// traversals of links is no change here. Throws PlaceMemoryError.
  std::vector<PastChange> history(std::size_t most) const;
  /// Takes back the newest `count` changes of the history: all or none. They leave the history, and
  /// taking back is no change in it. Returns them, newest first. Throws PlaceMemoryError
  /// (kNothingToUndo, kCannotUndo, kStoreFailed).
  std::vector<PastChange> undo(std::size_t count = 1);

  /// The map as one who drives along with it takes it up: scans and ties that were kept, and places
  /// that were learned otherwise; those whose readings are not known are left out. Waits for the
  /// disk. Throws PlaceMemoryError.
  KeptMap drivenMap() const;
  /// Keeps what a drive has made of drivenMap(), in one change: places that are new, moved or gone,
  /// and in the store scans and ties. A place that was removed meanwhile stays removed. Throws
  /// PlaceMemoryError; all is then as it was.
  void keep(const KeptMap& map);
  /// Of all that only the places that are new. Throws likewise.
  void keepNewPlaces(const KeptMap& map);
  /// Of a drive on a map that stays: links learn from it how the robot gets along, and nothing else
  /// changes. Throws likewise.
  void keepTravels(const KeptMap& map);

  /// Number of places.
  std::size_t size() const;
  /// Of the map: counts its changes.
  std::uint64_t version() const;
  /// The map as it is now.
  MapSnapshot map() const;
  std::optional<Place> place(PlaceId id) const;
  std::optional<Place> place(const std::string& label) const;
  /// The grid as it was learned, and adapted since; waits for the disk. Throws PlaceMemoryError.
  EvidenceGrid grid(PlaceId id) const;

  /// A route through the map as it is now. Meanwhile the map is not changed. Places that are not
  /// there, and ends that no way joins, are answers too.
  RoutePlan plan(const RouteQuery& query);
  /// The robot went along a link, or tried to: the link learns from it. recognize() and learn()
  /// report what they know of themselves. Throws PlaceMemoryError.
  void reportTraversal(const Traversal& traversal);
  /// `toll` [s] counts for kToll alone. Throws PlaceMemoryError.
  void setLink(PlaceId from, PlaceId to, LinkOrder order, double toll, bool both_ways);
  /// Chance of getting through each way, first to second and back, 0 where that is forbidden.
  /// Throws PlaceMemoryError where the two are not linked.
  std::pair<double, double> linkOdds(PlaceId first, PlaceId second) const;
  /// How links were travelled, the oldest first; waits for the disk. Throws PlaceMemoryError.
  std::vector<Traversal> traversals() const;

  Whereabouts whereabouts() const;
  /// The robot was carried, or time ran backwards: where it is now is not known.
  void forgetWhereabouts();
  /// From now on the robot is where this says, and no answer says otherwise: RECOGNIZED joins no
  /// sessions, and a place is learned where the drive has the robot. Nothing: the drive has ended.
  void followDrive(const std::optional<DriveWhereabouts>& whereabouts);

  /// Is called with every change from now on, in the order of their versions, once it is kept and
  /// seen by everybody, on the memory's own thread; who asked for the change waits for it. It must
  /// not ask for a change or for a grid (std::logic_error); what it throws is dropped.
  using Listener = std::function<void(const MapChange&)>;
  void listen(Listener listener);

  StoreHealth storeHealth() const;
  /// Is called whenever the store's health changes, like a listener.
  using HealthListener = std::function<void(const StoreHealth&)>;
  void watchStore(HealthListener listener);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_MEMORY_H
