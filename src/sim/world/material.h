#ifndef PLACE_MEMORY_SIM_WORLD_MATERIAL_H
#define PLACE_MEMORY_SIM_WORLD_MATERIAL_H

#include <map>
#include <string>

namespace place_memory::sim {

/// How a surface answers a sonar pulse. A surface smooth against the wavelength (7 mm at 49 kHz) is
/// a mirror: it sends an echo back only where the pulse meets it nearly head on (Leonard and
/// Durrant-Whyte, Directed Sonar Sensing; paper 3.1.3).
struct Material {
  double critical_angle =
      0.30;               ///< half-angle about the normal within which it echoes [rad], (0, pi/2]
  double strength = 0.9;  ///< echo amplitude head on, (0, 1]
  double mirror = 0.85;   ///< share of the amplitude that goes on mirrored, [0, 1]
};

using MaterialTable = std::map<std::string, Material>;

/// The materials every world knows: glass, whiteboard, metal, painted, wood, brick, furniture,
/// cloth.
const MaterialTable& standardMaterials();

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_WORLD_MATERIAL_H
