#ifndef PLACE_MEMORY_CORE_MEMORY_PLACE_MEMORY_IMPL_H
#define PLACE_MEMORY_CORE_MEMORY_PLACE_MEMORY_IMPL_H

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/memory/change_queue.h"
#include "core/memory/driven_places.h"
#include "core/memory/learned_scans.h"
#include "core/memory/map_writer.h"
#include "core/memory/store_merge.h"
#include "core/memory/whereabouts.h"
#include "core/recognize/recognizer.h"
#include "core/store/place_store.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

/// What PlaceMemory does, by the names that it has there. Learning is in place_learning.cpp,
/// recognizing in place_recognition.cpp, what belongs to a drive in place_driving.cpp, routes in
/// place_routes.cpp, what comes from or goes to other stores, and undoing, in map_travel.cpp, the
/// rest in place_memory.cpp.
class PlaceMemory::Impl {
 public:
  Impl(const PlaceMemoryOptions& options, PlaceStore store);

  Learned learn(const Scan& scan, const std::string& label, bool force);
  Answer recognize(const Scan& scan, std::optional<double> heading_window,
                   const std::function<bool()>& cancelled);
  void setOptions(const RecognizerOptions& recognizer, const AdaptationOptions& adaptation);
  void rename(const std::string& label, const std::string& new_label);
  void remove(const std::string& label);
  std::size_t clear();
  EvidenceGrid grid(PlaceId id);
  void save(const std::string& path);
  std::size_t load(const std::string& path);
  MergeReport merge(const std::string& path);
  std::vector<PastChange> history(std::size_t most);
  std::vector<PastChange> undo(std::size_t count);
  void forgetWhereabouts();
  RoutePlan plan(const RouteQuery& query);
  void reportTraversal(const Traversal& traversal);
  void setLink(PlaceId from, PlaceId to, LinkOrder order, double toll, bool both_ways);
  std::pair<double, double> linkOdds(PlaceId first, PlaceId second);
  std::vector<Traversal> traversals();
  KeptMap drivenMap();
  void keep(const KeptMap& map);
  void keepTravels(const KeptMap& map);
  void keepNewPlaces(const KeptMap& map);
  void followDrive(const std::optional<DriveWhereabouts>& whereabouts);

  MapWriter& writer() { return writer_; }

  /// What `look` returns of what everybody reads.
  template <class Look>
  auto read(const Look& look) const {
    const std::lock_guard<std::mutex> lock(state_.mutex);
    return look(static_cast<const MemoryState&>(state_));
  }

 private:
  /// By what a scan is recognized and folded, as one question finds it.
  struct Tuning {
    RecognizerOptions options;
    std::shared_ptr<const Recognizer> recognizer;  ///< of these options
    AdaptationOptions adaptation;
  };

  /// With what the map follows an answer.
  struct Following {
    PlaceId place = kNoPlace;  ///< RECOGNIZED
    Settled settled;
    std::chrono::nanoseconds scan_end{0};
    std::optional<Traversal> came;       ///< from the place where it was before to this one
    std::optional<EvidenceGrid> sensed;  ///< in the place's frame; none: the place does not adapt
    double retention = 0.0;              ///< of the old evidence in that place
  };

  /// Throws PlaceMemoryError where the scan is not one of this map.
  void check(const Scan& scan) const;

  /// Nothing where a place went or moved while it was matched.
  std::optional<Following> settle(const Scan& scan, std::uint64_t question,
                                  const std::map<PlaceId, PlaceFrame>& frames, Answer& answer);
  /// Whether the map may have to follow; where not, an answer waits for nobody.
  static bool changesMap(const Following& following);
  std::optional<EvidenceGrid> sensedAt(const Scan& scan, const Recognition& recognition,
                                       const AdaptationOptions& adaptation) const;
  static Tuning tuningOf(const RecognizerOptions& recognizer, const AdaptationOptions& adaptation);
  Tuning tuning() const;

  // For works of the queue.
  Learned learnNow(const Scan& scan, const std::string& label, std::uint64_t question);
  void follow(const Following& following, Answer& answer);
  /// Of the places of another store in the map as it is.
  std::vector<MergeSighting> sightingsOf(const PlaceMap& theirs, const PlaceStore& store) const;
  std::size_t join(const SessionJoin& join, std::vector<MapEdit>& edits) const;
  void traverse(const Following& following, std::vector<MapEdit>& edits);
  /// Where the two places are linked.
  std::optional<LinkLearned> learnedBy(const Traversal& traversal) const;
  bool fold(const Following& following, std::vector<MapEdit>& edits);
  SessionId mapSession() const;

  /// The way from where the robot stood last; for the holder of state_.mutex.
  Traversal wayTo(const Scan& scan, PlaceId from, PlaceId to) const;
  /// Of a query, for the holder of routes_mutex.
  const Place* placeAt(const RouteEnd& end, SessionId session) const;
  std::vector<RouteStart> startsOf(const RouteQuery& query) const;

  const double cell_size_;
  const bool located_;
  const SonarModel sonar_;

  mutable std::mutex tuning_mutex_;
  Tuning tuning_;

  /// Where the robot stood last, and when it had done there.
  struct Stood {
    PlaceId place = kNoPlace;
    std::chrono::nanoseconds until{0};
  };

  MemoryState state_;
  Stood stood_;  ///< guarded by state_.mutex
  const LinkLearningOptions links_;

  // For works of the queue, which alone change state_.map.
  MapWriter writer_;
  LearnedScans learned_scans_;
  DrivenPlaces driven_places_;
  std::optional<std::chrono::nanoseconds> last_folded_;  ///< when that scan ended
  /// To where a traversal was reported last, since a scan told where the robot is.
  PlaceId reported_to_ = kNoPlace;

  ChangeQueue queue_;  ///< ends before what it works on
};

/// The place with that label. Throws PlaceMemoryError.
const Place& findPlace(const PlaceMap& map, const std::string& label);
/// The label for a new place, or for one that is called differently from now on; "" asks for one
/// that is made up. Throws PlaceMemoryError.
std::string newLabel(const PlaceMap& map, const std::string& wanted);
/// Throws PlaceMemoryError.
[[noreturn]] void refuseLabel();
/// Where these places lie; nothing where one of them is gone.
std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& places,
                                                const PlaceMap& map);
/// In words, also where it is no place of the map.
std::string called(const PlaceMap& map, PlaceId id);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_PLACE_MEMORY_IMPL_H
