#include "core/memory/memory_views.h"

#include "core/route/route_reach.h"
#include "core/views/view_adviser.h"

namespace place_memory::core {
namespace {

// So far the robot is sent, and no farther, to find out where it is.
constexpr double kMostTime = 120.0;  // [s]

}  // namespace

ViewAdvice adviseView(const PlaceMemory& memory, const LinkLearningOptions& links,
                      std::chrono::nanoseconds now, const ViewQuestion& question) {
  const MapSnapshot snapshot = memory.map();
  const PlaceMap map(snapshot.places, snapshot.links, snapshot.version, snapshot.stamp);
  RouteGraph graph(links);
  graph.build(map);
  graph.refresh(map, now);
  const ViewAdviser adviser(
      [&](PlaceId id) -> std::shared_ptr<const EvidenceGrid> {
        try {
          return std::make_shared<const EvidenceGrid>(memory.grid(id));
        } catch (const PlaceMemoryError& error) {
          if (error.reason() == PlaceMemoryError::Reason::kUnknownPlace) return nullptr;
          throw;
        }
      },
      [&](const PoseCandidate& candidate) {
        std::vector<ViewPoint> points;
        for (const ReachedPlace& reached : reachedFrom(graph, candidate.place, kMostTime)) {
          const Pose2d& pose = map.find(reached.place)->map_from_place;
          points.push_back({reached.place, reached.before, pose, reached.time});
        }
        return points;
      });
  return adviser.advise(question);
}

}  // namespace place_memory::core
