#ifndef PLACE_MEMORY_SIM_SENSES_SONAR_PHYSICS_H
#define PLACE_MEMORY_SIM_SENSES_SONAR_PHYSICS_H

#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"
#include "sim/scene/scene.h"
#include "sim/world/random.h"

namespace place_memory::sim {

/// The qualities of a sonar that its data sheet's cone and range limits leave out. Defaults: a
/// Polaroid 6500 ring as on the Nomad 200 (paper 3.1.4).
struct SonarPhysics {
  double subray_spacing = 0.044;  ///< between the sub-rays of the cone [rad], > 0
  double edge_gain = 0.3;  ///< two-way amplitude at the edge of the cone, (0, 1]; 1 on its axis
  double reach = 9.0;      ///< a strong surface met head on is heard up to here [m], > 0
  int max_bounces = 3;     ///< mirrorings followed before an echo counts as lost, >= 0
  double roughness = 1.0;  ///< scales every critical angle: short waves find surfaces rough, > 0
  double threshold_noise = 0.2;    ///< 1 sigma of the log of the detection threshold, >= 0
  double relative_noise = 0.01;    ///< 1 sigma of the range, share of the range, >= 0
  double absolute_noise = 0.004;   ///< 1 sigma of the range [m], >= 0
  double range_scale = 1.0;        ///< speed of sound taken for granted over the true one, > 0
  double drop_probability = 0.01;  ///< echoes lost for no reason, [0, 1]
  double cross_talk = 0.004;       ///< chance to hear the neighbour's earlier echo, [0, 1]
};

/// One ping: the range that the sensor at `sensor` (in the world's frame) would report [m],
/// +infinity for no echo within its maximum and -infinity for one below its minimum (REP 117).
///
/// The cone is a fan of sub-rays. Each echoes from a surface that it meets inside the critical
/// angle and from corners, edges and circles that it passes, and goes on mirrored with the length
/// of the whole path: the long specular readings of the paper (3.1.3). The first echo loud enough
/// counts. People are circles beside the scene.
double pingSonar(const Scene& scene, const std::vector<Circle>& people, const core::Pose2d& sensor,
                 const core::SonarSpec& spec, const SonarPhysics& physics, Rng& rng);

/// `range` within the sensor's limits, infinities beyond them.
double clampToSpec(double range, const core::SonarSpec& spec);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SENSES_SONAR_PHYSICS_H
