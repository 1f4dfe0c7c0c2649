#include "mapping/drive_table.h"

#include "experiments/table.h"

namespace place_memory::mapping {
namespace {

using experiments::fixed;

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "" : fixed(static_cast<double>(part) / static_cast<double>(whole), 3);
}

}  // namespace

const std::vector<std::string>& driveHeader() {
  static const std::vector<std::string> kHeader{
      "world",      "sonars", "way", "online", "final", "scale free", "places", "doubled",
      "false ties", "wrong",  "of",  "median", "99 %",  "revisits",   "ms by m"};
  return kHeader;
}

std::vector<std::string> driveRow(const std::string& world, const std::string& sonars,
                                  const MappingFigures& found) {
  return {world,
          sonars,
          fixed(found.way, 0),
          fixed(found.online, 3),
          fixed(found.final, 3),
          fixed(found.final_scale_free, 3),
          std::to_string(found.places),
          std::to_string(found.doubled),
          std::to_string(found.false_ties),
          std::to_string(found.wrong),
          std::to_string(found.answers),
          fixed(found.median(), 3),
          fixed(found.p99(), 3),
          share(found.known, found.again),
          fixed(found.cpu, 1)};
}

}  // namespace place_memory::mapping
