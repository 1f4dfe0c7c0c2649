#ifndef PLACE_MEMORY_EXPERIMENTS_FIGURE_FILE_H
#define PLACE_MEMORY_EXPERIMENTS_FIGURE_FILE_H

#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "sim/world/vec2.h"

namespace place_memory::experiments {

/// One grid of a figure.
struct Panel {
  std::string title;
  core::EvidenceGrid grid;
  std::vector<sim::Vec2> circled;  ///< what is new, in the grid's frame [m]
};

struct GridFigure {
  std::string name;  ///< of the file, without an ending
  std::string caption;
  std::vector<Panel> panels;
};

/// A topological and metric map.
struct MapFigure {
  std::string name;
  std::string caption;
  std::vector<std::pair<std::string, sim::Vec2>> places;  ///< label and position [m]
  std::vector<std::pair<std::size_t, std::size_t>> links;
};

/// Writes FOLDER/NAME.json: name, caption and
///   panels: title; cell_size [m]; evidence, 64 rows from the least y of 64 cells from the least x,
///     in steps of 1 / EvidenceGrid::kStepsPerNat; circled, points [x, y]; or
///   places: label, x, y; and links: pairs of indices.
/// Throws std::runtime_error where the file cannot be written.
void writeFigure(const GridFigure& figure, const std::string& folder);
void writeFigure(const MapFigure& figure, const std::string& folder);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_FIGURE_FILE_H
