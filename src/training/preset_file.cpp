#include "training/preset_file.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace place_memory::training {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

}  // namespace

void writePreset(const std::string& path, const std::string& origin,
                 const config::MatchPreset& preset) {
  std::ofstream file(path);
  file << "# " << origin << "\n\n"
       << "# Points for a pair of corresponding cells. Rows: class of the recognition grid's cell "
          "(empty,\n# unsensed, occupied); columns: of the learned grid's cell, likewise. Each in "
          "[-1000, 1000].\nweights:\n";
  for (const auto& row : preset.metric.weights) {
    file << "  - [" << number(row[0]) << ", " << number(row[1]) << ", " << number(row[2]) << "]\n";
  }
  const core::Calibration& c = preset.calibration;
  file
      << "\n# What an alignment costs that is far from where the robot is expected to stand.\n"
      << "shift_cost: " << number(preset.metric.shift_cost)
      << "  # of the shift's square [points / m^2], >= 0\n"
      << "turn_cost: " << number(preset.metric.turn_cost)
      << "  # of a turn to the edge of the heading window, by its square [points], >= 0\n\n"
      << "# From scores to probabilities: the log odds that the best match is right are\n"
      << "# bias + margin * log(1 + scale * (best - runner-up)) and, for each kind of pair, its "
         "factor\n# times the share of the scan's cells of the first class that fall on the second."
         "\ncalibration:\n"
      << "  scale: " << number(c.scale) << "  # [1 / score], in (0, 1000]\n"
      << "  bias: " << number(c.bias) << "  # in [-1000, 1000]\n"
      << "  empty_on_empty: " << number(c.shares[0][0]) << "  # in [-1000, 1000]\n"
      << "  empty_on_occupied: " << number(c.shares[0][1]) << "  # in [-1000, 1000]\n"
      << "  occupied_on_empty: " << number(c.shares[1][0]) << "  # in [-1000, 1000]\n"
      << "  occupied_on_occupied: " << number(c.shares[1][1]) << "  # in [-1000, 1000]\n"
      << "  margin: " << number(c.margin) << "  # in [0, 1000]\n"
      << "  sharpness: " << number(c.sharpness)
      << "  # of a pose's likelihood by its score, for the covariance [1 / score], in [0, 1000]\n"
      << "  others: " << number(c.others)
      << "  # share of the remaining probability that the other places get, in [0, 1]\n";
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace place_memory::training
