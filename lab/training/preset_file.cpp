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

void writeTable(std::ostream& out, const std::string& indent, const core::PairWeights& weights) {
  for (const auto& row : weights) {
    out << indent << "- [" << number(row[0]) << ", " << number(row[1]) << ", " << number(row[2])
        << "]\n";
  }
}

void writeRescoring(std::ostream& out, const core::RescoringWeights& rescoring) {
  out << "\n# Re-scoring of the places that score best: `search_score` times their score, points "
         "for "
         "pairs of\n# cells within nine cells of the place and from there to seventeen, for pairs "
         "that lie near one\n# another, and for the peak's sharpness: how the search's score "
         "changes "
         "by a shift of two cells and\n# by a rotation of six degrees.\nrescoring:\n  "
         "search_score: "
      << number(rescoring.search_score) << "  # in [0, 1000]\n  inner:\n";
  writeTable(out, "    ", rescoring.inner);
  out << "  middle:\n";
  writeTable(out, "    ", rescoring.middle);
  for (std::size_t i = 0; i < core::kNearPairs; ++i) {
    out << "  " << core::kNearPairsNames[i] << ": " << number(rescoring.near[i])
        << "  # in [-1000, 1000]\n";
  }
  out << "  peak_sharpness_shift: " << number(rescoring.peak_sharpness_shift)
      << "  # in [-1000, 1000]\n"
      << "  peak_sharpness_rotation: " << number(rescoring.peak_sharpness_rotation)
      << "  # in [-1000, 1000]\n";
}

void writeCoefficients(std::ostream& out, const core::CalibrationFeatures& coefficients) {
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    out << "    " << core::kCalibrationFeatureNames[i] << ": " << number(coefficients[i])
        << "  # in [-1000, 1000]\n";
  }
}

}  // namespace

void writePreset(const std::string& path, const std::string& origin,
                 const config::MatchPreset& preset) {
  std::ofstream file(path);
  file << "# " << origin << "\n\n"
       << "# Points for a pair of corresponding cells. Rows: class of the recognition grid's cell "
          "(empty,\n# unsensed, occupied); columns: of the learned grid's cell, likewise. Each in "
          "[-1000, 1000].\nweights:\n";
  writeTable(file, "  ", preset.metric.weights);
  file << "\n# What an alignment costs that is far from where the robot is expected to stand.\n"
       << "shift_cost: " << number(preset.metric.shift_cost)
       << "  # of the shift's square [points / m^2], >= 0\n"
       << "rotation_cost: " << number(preset.metric.rotation_cost)
       << "  # of a rotation to the edge of the heading window, by its square [points], >= 0\n";
  if (preset.metric.overlap_only) {
    file << "\n# Only cells where the moved recognition grid and the learned one overlap are "
            "pairs.\n"
            "overlap_only: true\n";
  }
  if (preset.rescoring) writeRescoring(file, *preset.rescoring);
  const core::Calibration& c = preset.calibration;
  file << "\n# From scores to probabilities: coefficients of log odds. What they are taken with: "
          "kCalibrationFeatureNames\n# in place_memory/core/calibration.h.\ncalibration:\n"
       << "  scale: " << number(c.scale) << "  # [1 / score], in (0, 1000]\n"
       << "  right:  # that the best match is right\n";
  writeCoefficients(file, c.right);
  file << "  known:  # that the scan is of any place of the memory\n";
  writeCoefficients(file, c.known);
  file << "  sharpness: " << number(c.sharpness)
       << "  # of a pose's likelihood by its score, for the covariance [1 / score], in [0, 1000]\n";
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace place_memory::training
