#ifndef PLACE_MEMORY_CORE_SONAR_MODEL_H
#define PLACE_MEMORY_CORE_SONAR_MODEL_H

#include <array>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/sonar_reading.h"
#include "place_memory/export.h"

namespace place_memory::core {

struct SonarModelOptions {
  double prior = 0.5;      ///< probability that a cell is occupied, in (0, 1) (paper 3.1.1)
  double occupied = 0.75;  ///< of a cell on the cone's axis where the echo came from, in (prior, 1)
  double empty = 0.35;     ///< of a cell on the cone's axis that the sound passed, in (0, prior)
  /// How far before and behind the echo cells are occupied [cells], in [0.5, 8].
  double echo_depth = 1.4;
};

/// What a reading says of the cells in its cone (paper 3.1.1).
///
/// Evidence is strongest on the axis and fades towards the cone's edge as 1 - (angle / half
/// angle)^2. Cells before the echo become emptier, those within echo_depth of it more occupied,
/// those behind it are left alone. Where the arc of the echo is wider than three cells, its
/// evidence falls with the root of the width. A cone that is narrower than a cell still touches the
/// cells it passes.
class PLACE_MEMORY_PUBLIC SonarModel {
 public:
  /// Throws std::invalid_argument naming the option that is out of range.
  explicit SonarModel(const SonarModelOptions& options);

  /// Adds the evidence of a reading, one addition a cell (paper 3.1.3). The reading is in the
  /// grid's frame.
  void add(const SonarReading& reading, EvidenceGrid& grid) const;

  EvidenceGrid build(const std::vector<SonarReading>& readings, GridGeometry geometry) const;

 private:
  static constexpr int kBins = 64;

  SonarModelOptions options_;
  double occupied_evidence_;                     ///< [1 / EvidenceGrid::kStepsPerNat nats], > 0
  double empty_evidence_;                        ///< likewise, < 0
  std::array<double, kBins + 1> angle_profile_;  ///< over |offset from the axis| / half width
  std::array<double, kBins + 1> echo_profile_;   ///< over |distance from the echo| / echo depth
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SONAR_MODEL_H
