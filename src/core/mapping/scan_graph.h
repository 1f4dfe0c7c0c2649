#ifndef PLACE_MEMORY_CORE_MAPPING_SCAN_GRAPH_H
#define PLACE_MEMORY_CORE_MAPPING_SCAN_GRAPH_H

#include <cstddef>
#include <optional>
#include <vector>

#include "core/map/kept_map.h"
#include "core/map/pose_relaxation.h"

namespace place_memory::core {

/// How far a way through the graph leads a tracked robot astray [m]; by its length [m].
double positionSigma(double way, bool compass);
/// By how much the same way turns it [rad].
double yawSigma(double way);

/// All scans of the way and what ties them; the owner of their poses.
class ScanGraph {
 public:
  const std::vector<ScanNode>& nodes() const { return nodes_; }
  ScanNode& node(NodeIndex at) { return nodes_[at]; }
  const ScanNode& node(NodeIndex at) const { return nodes_[at]; }
  const std::vector<Tie>& ties() const { return ties_; }
  bool tied(NodeIndex at) const { return !ties_of_[at].empty(); }
  const OdometryErrors& errors() const { return errors_; }
  /// How well they are known: the closed loops tell.
  const OdometryErrors& errorSigmas() const { return error_sigmas_; }

  NodeIndex append(ScanNode node);
  /// Takes the place of everything: as it was kept, or thinned. Indices are those in `nodes`.
  void assign(std::vector<ScanNode> nodes, std::vector<Tie> ties, const OdometryErrors& errors);
  /// Where odometry puts a node after the one before it, its errors taken out.
  Pose2d predicted(const ScanNode& node) const;

  void tie(const Tie& tie);
  /// Removes every tie for which `gone` holds.
  template <typename Gone>
  void untie(const Gone& gone);

  struct Step {
    NodeIndex to;
    double way;  ///< [m]
  };
  /// The nodes that odometry or a tie leads to; a tie that the poses agree with is hardly any way.
  void steps(NodeIndex from, std::vector<Step>& found) const;

  /// Moves the newest `count` nodes of the session, the others held.
  void relaxRecent(std::size_t count);
  /// Moves all nodes of a session; its first stays. `trusted`: ties of that closure are believed
  /// however far they are off, so that it is found where they lead to; 0: none.
  void relaxAll(int session, int iterations, int trusted = 0);
  /// By how much the compass erred at a place, by the mean of what is tied to it [rad].
  std::optional<double> compassDeviation(NodeIndex place) const;
  /// Squared distance of a tie from the poses [sigma^2].
  double chiSquare(const Tie& tie) const;
  /// Moves a whole session into another's frame.
  void join(int session, int into, const Pose2d& into_from_session);
  /// Odometry says nothing of how the robot came to this node.
  void cutBefore(NodeIndex node);
  /// Makes a session again of the nodes from `first` on.
  void split(NodeIndex first, int session, const Pose2d& session_from_poses);
  /// What relaxing changes.
  struct Lie {
    std::vector<Pose2d> poses;
    OdometryErrors errors, error_sigmas;
  };
  Lie lie() const;
  void setLie(const Lie& lie);

 private:
  RelaxationProblem problemOf(const std::vector<NodeIndex>& free, int session, int trusted) const;
  void indexTies();

  std::vector<ScanNode> nodes_;
  std::vector<Tie> ties_;
  std::vector<std::vector<std::size_t>> ties_of_;  ///< by node, of either end
  std::vector<std::vector<NodeIndex>> next_of_;    ///< by node, those that came from it
  OdometryErrors errors_;
  OdometryErrors error_sigmas_{kBendSigma, kTurnFactorSigma};
};

template <typename Gone>
void ScanGraph::untie(const Gone& gone) {
  std::vector<Tie> kept;
  for (const Tie& tie : ties_) {
    if (!gone(tie)) kept.push_back(tie);
  }
  ties_ = std::move(kept);
  indexTies();
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_SCAN_GRAPH_H
