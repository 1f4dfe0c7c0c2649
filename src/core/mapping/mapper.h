#ifndef PLACE_MEMORY_CORE_MAPPING_MAPPER_H
#define PLACE_MEMORY_CORE_MAPPING_MAPPER_H

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/map/kept_map.h"
#include "core/map/place_belief.h"
#include "core/mapping/closure_candidates.h"
#include "core/mapping/closure_question.h"
#include "core/mapping/continuity_watch.h"
#include "core/mapping/dead_reckoning.h"
#include "core/mapping/loop_closer.h"
#include "core/mapping/lost_estimate.h"
#include "core/mapping/mapper_event.h"
#include "core/mapping/mapper_options.h"
#include "core/mapping/moving_scan.h"
#include "core/mapping/newest_readings.h"
#include "core/mapping/place_shelf.h"
#include "core/mapping/scan_graph.h"
#include "core/mapping/scan_tying.h"
#include "core/mapping/way_search.h"
#include "core/sensing/heading_history.h"

namespace place_memory::core {

/// What became of one moving scan.
struct ScanDecision {
  enum class Kind { kNewPlace, kTracked, kClosed, kCandidate, kBetween, kLost };

  std::chrono::nanoseconds stamp{0};  ///< of the middle of its stretch
  Kind kind = Kind::kBetween;
  PlaceId place = kNoPlace;  ///< that it names
  Pose2d place_from_base;    ///< where the robot stood, in the frame in which it stood at the place
  double belief = 0.0;       ///< probability of that place
  double lost = 0.0;         ///< probability that the robot is not where map_from_odom has it
  ScanWitness witness = ScanWitness::kSilent;  ///< what it showed of that
  Spot spot;           ///< of the way since the scan before, where what is sensed goes on least
  std::string reason;  ///< in words: why this and nothing else
};

/// "new_place", "tracked", "closed", "candidate", "between" or "lost", as tables have it.
const char* nameOf(ScanDecision::Kind kind);

/// A place at which the robot may be.
struct BelievedPlace {
  PlaceId id = kNoPlace;
  double probability = 0.0;
  Pose2d map_from_base;  ///< where it is then
};

/// The belief as others are told it.
struct BeliefSummary {
  std::vector<BelievedPlace> places;  ///< the most probable, most probable first
  double off_map = 1.0;
  double lost = 1.0;
  Pose2d odom_from_base;  ///< at the moment that it speaks of
  /// What the newest scan showed; nullptr: there was none since where the robot is became unknown.
  std::shared_ptr<const EvidenceGrid> seen;
  Pose2d seen_from_base;  ///< where the robot was in that grid at the same moment
};

/// A place of the map.
struct MappedPlace {
  PlaceId id = kNoPlace;
  std::string label;
  std::chrono::nanoseconds stamp{0};  ///< of the middle of the stretch that it was made of
  Pose2d map_from_base;               ///< where the robot stood then
  bool apart = false;                 ///< of a session that is not joined to the map: in its frame
};

/// Drives along with the robot: makes a map of places as it goes, knows them again, corrects dead
/// reckoning by them and closes loops; or only tells where it is on a map that stays.
///
/// Fed in the order of stamps. The same data gives the same map, however fast it comes: whatever is
/// worked out is worked out at points of the way. Not thread-safe, and it has no threads.
class Mapper {
 public:
  explicit Mapper(const MapperOptions& options);
  Mapper(const Mapper&) = delete;
  Mapper& operator=(const Mapper&) = delete;

  /// A compass heading [rad].
  void addHeading(std::chrono::nanoseconds stamp, double yaw);
  /// Odometry's newest pose.
  void addOdometry(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base);
  /// A reading in the base's frame, with odometry's pose at its stamp.
  void addReading(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base,
                  const SonarReading& reading);
  /// How the robot got to where it is now is not known: it was carried, or odometry starts anew.
  void beginSession();
  void setMode(MapperMode mode);
  MapperMode mode() const { return options_.mode; }

  /// Somebody says where the robot is on the map, which has been there before: it goes on from
  /// there, until scans say otherwise.
  void setPose(const Pose2d& map_from_base);
  /// The scan of a robot that stood, or turned on the spot: readings in the base's frame, and where
  /// odometry had that. It becomes a node, and no place by itself.
  void addStanding(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base,
                   std::vector<SonarReading> readings);
  /// The standing scan of that stamp is a place, by a person's word, with an id that nobody had;
  /// places of the drive's own that it doubles go.
  void adopt(PlaceId id, std::chrono::nanoseconds stamp);
  /// A person gave the place a name: it goes no more because it seems doubled.
  void setNamed(PlaceId id) { named_.insert(id); }
  /// The place is gone, by a person's word; its scan stays in the graph.
  void forget(PlaceId id);

  /// Where scans that agree say that the robot is, too few of them yet for the map to follow.
  std::vector<ClosureQuestion> closureQuestions() const;
  /// A person says that the robot is at the place of a question, or that it is not: then nothing
  /// comes of it, and a closure there that is new is taken back.
  ClosureWord confirmClosure(PlaceId place);
  ClosureWord cutClosure(PlaceId place);

  /// What became of scans since it was asked last. Where a scan becomes a place only later, since
  /// it was not clear whether a loop closes, there is a second decision with its stamp, which takes
  /// the place of the first.
  std::vector<ScanDecision> takeDecisions();
  /// Likewise beyond single scans.
  std::vector<MapperEvent> takeEvents();

  /// Corrects odometry's newest pose; nothing while where the robot is is not known.
  std::optional<Pose2d> mapFromOdom() const {
    return session_ == kMapSession ? sessionFromOdom() : std::nullopt;
  }
  /// The same in the frame of the robot's session, which may be apart.
  std::optional<Pose2d> sessionFromOdom() const;
  /// In whose frame the robot's pose is; 1: the map's.
  int session() const { return session_; }
  /// Way since a place told where the robot is [m].
  double untiedWay() const { return reckoning_.way() - anchored_way_; }
  /// Probability that it is wrong, or 1 where there is none.
  double lost() const { return session_ == 1 ? lost_.probability() : 1.0; }

  /// Over the places of the map; kept up with every scan.
  BeliefSummary belief() const;

  std::vector<MappedPlace> places() const;
  /// Everything that makes the map, to be kept.
  KeptMap map() const {
    return {graph_.nodes(),
            graph_.ties(),
            graph_.errors(),
            shelf_.nextId(),
            {named_.begin(), named_.end()}};
  }
  /// Takes up a map that was kept, in a mapper that has none; where the robot is on it is not
  /// known. Throws std::invalid_argument where the mapper has one, or an index or a number of `map`
  /// is wrong.
  void restore(const KeptMap& map);
  const ScanGraph& graph() const { return graph_; }
  /// What the wheels get wrong all the time, as far as loops have shown it, and to what sigmas.
  const OdometryErrors& odometryErrors() const { return graph_.errors(); }
  const OdometryErrors& odometryErrorSigmas() const { return graph_.errorSigmas(); }
  /// Nodes before this one are of the map that was taken up.
  NodeIndex firstOfDrive() const { return first_of_drive_; }
  /// The scans of this drive, without their readings, where they lie now; with `keep_way` also
  /// those that were thinned out.
  std::vector<ScanNode> way() const;

 private:
  /// Where somebody said that the robot is, and where dead reckoning had it then.
  struct ToldPose {
    Pose2d map_from_base;
    Pose2d reckoned;
  };

  static constexpr int kMapSession = 1;       ///< in whose frame the map lies
  static constexpr std::size_t kWindow = 40;  ///< nodes that a local correction moves
  /// Agreement of the newest readings with what should be there from which they are of it.
  static constexpr double kAgrees = 0.4;

  /// What one scan showed.
  struct View {
    LaidScan laid;
    bool at_place = false;                  ///< one is near where the robot thinks it is
    NewestReadings::Agreement agreement{};  ///< with the place that should be there
    bool tracked = false;
    double best = 0.0;               ///< probability of the best place
    std::vector<Sighting> loops{};   ///< elsewhere, where odometry may have brought the robot
    std::vector<Sighting> beyond{};  ///< elsewhere, where it cannot have
  };

  void process(const MovingScan& scan);
  View look(NodeIndex at, const MovingScan& scan);
  void lookForOwnSession(NodeIndex at, View& view);
  void speakOfLoops(NodeIndex at, const MovingScan& scan, const View& view);
  void speakOfJoins(NodeIndex at, const MovingScan& scan, const View& view);
  void growMap(NodeIndex at);
  NodeIndex append(const MovingScan& scan);
  double headingWindow() const;
  std::vector<PlaceFit> recognizeAnyhow(const PlaceMatcher& places, const LaidScan& scan,
                                        const std::vector<PlaceFit>& fits) const;
  std::function<bool(const Pose2d&)> placeNear(int session, NodeIndex at) const;
  void sortOut(const std::vector<Sighting>& sightings, NodeIndex at, WaySearch& ways,
               View& view) const;
  const ClosureCandidate* accepted(const ClosureCandidates& candidates, int target) const;
  double mostSigma(NodeIndex at) const;
  bool closeLoops(double way);
  bool close(const ClosureCandidate& candidate, int target, double way);
  void takeBack();
  PlaceBelief::Map beliefMap() const;
  void believe(NodeIndex at, const std::vector<PlaceFit>& fits, const LaidScan& scan);
  ScanWitness witnessOf(NodeIndex at, const View& view) const;
  bool straddlesBreak(NodeIndex at) const;
  NodeIndex firstAstray() const;
  Spot noticeBreak(NodeIndex at);
  void judgeLost(NodeIndex at, const View& view, ScanDecision& decision);
  void partWays();
  void beginApart();
  void tidy();
  void makePlaces();
  ScanDecision lateDecision(NodeIndex at) const;
  std::string tooFast(NodeIndex at) const;
  void thinOut();
  void remember(const std::vector<ScanNode>& before,
                const std::vector<std::optional<NodeIndex>>& now);
  void afterRelaxing();
  bool inDoubt(const View& view) const;
  void name(NodeIndex at, const View& view, ScanDecision& decision) const;
  std::string reasonOf(NodeIndex at, const View& view, const ScanDecision& decision) const;
  void note(MapperEvent::Kind kind, const ClosureCandidate* candidate = nullptr);

  MapperOptions options_;
  DeadReckoning reckoning_;
  MovingScanBuilder builder_;
  ContinuityWatch continuity_;
  HeadingHistory headings_;
  ScanGraph graph_;
  PlaceShelf shelf_;
  ScanTying tying_;
  NewestReadings newest_;
  LoopCloser closer_;
  ClosureCandidates loops_;    ///< within the session's own frame
  ClosureCandidates carried_;  ///< likewise, where odometry cannot have brought the robot
  ClosureCandidates joins_;    ///< with the map, while the session is apart
  std::vector<ScanDecision> decisions_;
  std::vector<MapperEvent> events_;
  std::set<PlaceId> named_;           ///< see setNamed()
  std::vector<NodeIndex> undecided_;  ///< scans of which places may be made yet
  int session_ = 1;                   ///< in whose frame the robot's pose is
  int last_session_ = 1;
  bool first_of_session_ = true;
  NodeIndex first_of_drive_ = 0;
  struct ThinnedScan {
    ScanNode node;  ///< its pose is beside that place
    PlaceId place;
  };
  std::vector<ThinnedScan> thinned_;
  std::optional<BaseMoment> last_middle_;  ///< of the newest node
  bool is_told_ = false;                   ///< by a person where it is, until it is tied
  std::optional<ToldPose> told_;           ///< until a scan is there
  bool standing_ = false;                  ///< the scan that is processed is one of one spot
  Pose2d newest_odom_;
  double anchored_way_ = 0.0;              ///< at the last tie
  std::chrono::nanoseconds map_stamp_{0};  ///< of the newest scan of the map that is localized in
  std::size_t scans_since_full_ = 0;
  bool ties_since_full_ = false;
  bool compass_guides_ = false;  ///< to the map: what it errs by is known, and little everywhere
  LostEstimate lost_;
  std::optional<double> break_way_;  ///< where it was carried, if it was [m]
  PlaceBelief belief_;
  Pose2d believed_odom_;  ///< of the base when belief_ was brought up to date
  std::shared_ptr<const EvidenceGrid> seen_;
  Pose2d seen_from_base_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_MAPPER_H
