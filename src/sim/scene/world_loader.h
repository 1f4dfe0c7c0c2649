#ifndef PLACE_MEMORY_SIM_SCENE_WORLD_LOADER_H
#define PLACE_MEMORY_SIM_SCENE_WORLD_LOADER_H

#include <stdexcept>
#include <string>

#include "sim/world/world.h"

namespace place_memory::sim {

/// A world that cannot be used: "file:line: what", or "name: what" for one built in code.
class WorldError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a world file; its layout is described in config/worlds/README.md. Throws WorldError for an
/// unreadable file, a syntax error, an unknown, missing or mistyped key, a number out of its range,
/// a name used twice, a link to no place and a place where no robot can stand.
World loadWorld(const std::string& path);

/// The same from text; `origin` stands for the file name in errors.
World parseWorld(const std::string& text, const std::string& origin);

/// Throws WorldError where labels or names repeat, a link leads nowhere, or a disc of `clearance`
/// [m] at a place touches something.
void validateWorld(const World& world, double clearance);

/// What a robot of the paper's size needs about a place [m]: two feet across.
constexpr double kPlaceClearance = 0.3;

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_WORLD_LOADER_H
