#include "place_memory/core/sonar_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace place_memory::core {
namespace {

/// Width of the arc up to which an echo gives a cell all its evidence [cells].
constexpr double kSureArc = 3.0;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("sonar model: ") + what);
}

double evidenceOf(double probability, double prior) {
  return EvidenceGrid::kStepsPerNat *
         (std::log(probability / (1.0 - probability)) - std::log(prior / (1.0 - prior)));
}

/// Least half width of a cone [cells]: half a cell's diagonal, since a line that passes a cell
/// comes that near to its centre.
constexpr double kLeastHalfWidth = 0.70710678;

struct Span {
  int first;
  int last;
};

/// Rows or columns whose cells may lie within `reach` of a coordinate.
Span spanAround(const GridGeometry& geometry, double coordinate, double reach) {
  const double limit = 2.0 * geometry.halfWidth();
  const double low = std::clamp(coordinate - reach, -limit, limit);
  const double high = std::clamp(coordinate + reach, -limit, limit);
  return {std::max(geometry.index(low), 0), std::min(geometry.index(high), kGridSize - 1)};
}

}  // namespace

SonarModel::SonarModel(const SonarModelOptions& options) : options_(options) {
  require(options.prior > 0.0 && options.prior < 1.0, "prior must lie in (0, 1)");
  require(options.occupied > options.prior && options.occupied < 1.0,
          "occupied must lie in (prior, 1)");
  require(options.empty > 0.0 && options.empty < options.prior, "empty must lie in (0, prior)");
  require(options.echo_depth >= 0.5 && options.echo_depth <= 8.0,
          "echo_depth must lie in [0.5, 8] cells");
  occupied_evidence_ = evidenceOf(options.occupied, options.prior);
  empty_evidence_ = evidenceOf(options.empty, options.prior);
  for (std::size_t i = 0; i <= kBins; ++i) {
    const double share = static_cast<double>(i) / kBins;
    angle_profile_[i] = 1.0 - share * share;
    echo_profile_[i] = 1.0 - share * share;
  }
}

void SonarModel::add(const SonarReading& reading, EvidenceGrid& grid) const {
  const GridGeometry& geometry = grid.geometry();
  const bool echo = std::isfinite(reading.range);
  const double range = echo ? reading.range : reading.spec.max_range;
  const double depth = options_.echo_depth * geometry.cell_size;
  const double reach = echo ? range + depth : range;
  const double sine_half = std::sin(0.5 * reading.spec.field_of_view);
  // An echo came from somewhere along the arc: the wider that is, the less it says of each cell.
  const double arc = 2.0 * range * sine_half / (kSureArc * geometry.cell_size);
  const double echo_evidence = occupied_evidence_ / std::sqrt(std::max(arc, 1.0));
  const double cosine = std::cos(reading.sensor_pose.yaw);
  const double sine = std::sin(reading.sensor_pose.yaw);
  const Span rows = spanAround(geometry, reading.sensor_pose.y, reach);
  const Span columns = spanAround(geometry, reading.sensor_pose.x, reach);

  for (int row = rows.first; row <= rows.last; ++row) {
    const double dy = geometry.centre(row) - reading.sensor_pose.y;
    for (int column = columns.first; column <= columns.last; ++column) {
      const double dx = geometry.centre(column) - reading.sensor_pose.x;
      const double along = cosine * dx + sine * dy;
      if (along < 0.0) continue;
      const double across = std::abs(cosine * dy - sine * dx);
      const double distance = std::hypot(along, across);
      const double half_width =
          std::max(distance * sine_half, kLeastHalfWidth * geometry.cell_size);
      if (across >= half_width || distance > reach) continue;
      const double on_axis = angle_profile_[static_cast<std::size_t>(across / half_width * kBins)];
      const double from_echo = distance - range;
      double evidence = 0.0;
      if (echo && from_echo > -depth) {
        const double share = std::min(std::abs(from_echo) / depth, 1.0);
        evidence = echo_evidence * echo_profile_[static_cast<std::size_t>(share * kBins)];
      } else {
        evidence = empty_evidence_;
      }
      grid.add(row, column, static_cast<int>(std::lround(evidence * on_axis)));
    }
  }
}

EvidenceGrid SonarModel::build(const std::vector<SonarReading>& readings,
                               GridGeometry geometry) const {
  EvidenceGrid grid(geometry);
  for (const SonarReading& reading : readings) add(reading, grid);
  return grid;
}

}  // namespace place_memory::core
