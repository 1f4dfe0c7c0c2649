#include "experiments/figure_file.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace place_memory::experiments {
namespace {

using nlohmann::json;

json rowsOf(const core::EvidenceGrid& grid) {
  json rows = json::array();
  for (int row = 0; row < core::kGridSize; ++row) {
    json cells = json::array();
    for (int column = 0; column < core::kGridSize; ++column) {
      cells.push_back(static_cast<int>(grid.at(row, column)));
    }
    rows.push_back(cells);
  }
  return rows;
}

void write(const json& figure, const std::string& path) {
  std::ofstream file(path);
  file << figure << '\n';
  file.close();
  if (!file) throw std::runtime_error("cannot write the figure " + path);
}

}  // namespace

void writeFigure(const GridFigure& figure, const std::string& folder) {
  json panels = json::array();
  for (const Panel& panel : figure.panels) {
    json circled = json::array();
    for (const sim::Vec2& point : panel.circled) circled.push_back({point.x, point.y});
    panels.push_back({{"title", panel.title},
                      {"cell_size", panel.grid.geometry().cell_size},
                      {"evidence", rowsOf(panel.grid)},
                      {"circled", circled}});
  }
  write({{"name", figure.name}, {"caption", figure.caption}, {"panels", panels}},
        folder + "/" + figure.name + ".json");
}

void writeFigure(const MapFigure& figure, const std::string& folder) {
  json places = json::array();
  for (const auto& [label, position] : figure.places) {
    places.push_back({{"label", label}, {"x", position.x}, {"y", position.y}});
  }
  json links = json::array();
  for (const auto& [from, to] : figure.links) links.push_back({from, to});
  write({{"name", figure.name}, {"caption", figure.caption}, {"places", places}, {"links", links}},
        folder + "/" + figure.name + ".json");
}

}  // namespace place_memory::experiments
