#include "node/map/fused_map_message.h"

#include <array>
#include <cstdint>

namespace place_memory::node {
namespace {

constexpr std::int8_t kOccupied = 100;
constexpr std::int8_t kEmpty = 0;
constexpr std::int8_t kUnknown = -1;

/// The value of each evidence, from -127 up.
using Values = std::array<std::int8_t, 2 * core::EvidenceGrid::kLimit + 1>;

Values valuesOf(const config::MapOptions& options, double prior) {
  Values values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int evidence = static_cast<int>(i) - core::EvidenceGrid::kLimit;
    const double probability = core::EvidenceGrid::probability(evidence, prior);
    values[i] = kUnknown;
    if (evidence != 0 && probability >= options.occupied) values[i] = kOccupied;
    if (evidence != 0 && probability <= options.empty) values[i] = kEmpty;
  }
  return values;
}

}  // namespace

nav_msgs::OccupancyGrid toMessage(const core::FusedCells& cells, const config::MapOptions& options,
                                  double sonar_prior, const std_msgs::Header& header) {
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(cells.resolution);
  message.info.origin.orientation.w = 1.0;
  if (cells.evidence.empty()) {
    message.info.width = 1;
    message.info.height = 1;
    message.data = {kUnknown};
    return message;
  }
  message.info.width = static_cast<std::uint32_t>(cells.columns);
  message.info.height = static_cast<std::uint32_t>(cells.rows);
  message.info.origin.position.x = cells.left;
  message.info.origin.position.y = cells.bottom;
  const Values values = valuesOf(options, sonar_prior);
  message.data.reserve(cells.evidence.size());
  for (const std::int8_t evidence : cells.evidence) {
    message.data.push_back(values[static_cast<std::size_t>(evidence + core::EvidenceGrid::kLimit)]);
  }
  return message;
}

}  // namespace place_memory::node
