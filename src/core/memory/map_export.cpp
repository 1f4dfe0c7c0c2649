#include "core/memory/map_export.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <locale>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "core/mapping/fused_map.h"
#include "support/csv.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

constexpr double kWhite = 255.0;
// So far from the prior a cell counts as sensed.
constexpr double kThreshold = 0.005;
constexpr int kDigits = 10;

/// Writes numbers alike in every language.
class Text : public std::ostringstream {
 public:
  Text() {
    imbue(std::locale::classic());
    *this << std::setprecision(kDigits);
  }
};

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

void write(const std::string& path, const std::string& content, std::vector<std::string>& files) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
  files.push_back(path);
}

/// What an image of map_server shows: cells row by row, the least y first.
struct Cells {
  int columns = 0;
  int rows = 0;
  const std::int8_t* evidence = nullptr;
};

/// Of a map_server image: dark is occupied, the first row is that of the greatest y.
std::string asPgm(const Cells& cells, double prior) {
  Text text;
  text << "P5\n" << cells.columns << ' ' << cells.rows << "\n255\n";
  for (int row = cells.rows - 1; row >= 0; --row) {
    for (int column = 0; column < cells.columns; ++column) {
      const int evidence =
          cells.evidence[static_cast<std::ptrdiff_t>(row) * cells.columns + column];
      const double occupied = EvidenceGrid::probability(evidence, prior);
      text << static_cast<char>(static_cast<unsigned char>(std::lround(kWhite * (1.0 - occupied))));
    }
  }
  return text.str();
}

/// `corner`: pose of the image's lower left corner in the map.
std::string asYaml(const std::string& image, double resolution, const Pose2d& corner,
                   double prior) {
  Text text;
  text << "image: " << image << "\nresolution: " << resolution << "\norigin: [" << corner.x << ", "
       << corner.y << ", " << corner.yaw << "]\nnegate: 0\noccupied_thresh: " << prior + kThreshold
       << "\nfree_thresh: " << prior - kThreshold << "\nmode: trinary\n";
  return text.str();
}

/// Writes the two files of an image of map_server.
void writeImage(const std::string& folder, const std::string& name, const Cells& cells,
                double resolution, const Pose2d& corner, double prior,
                std::vector<std::string>& files) {
  write(folder + "/" + name + ".pgm", asPgm(cells, prior), files);
  write(folder + "/" + name + ".yaml", asYaml(name + ".pgm", resolution, corner, prior), files);
}

}  // namespace

std::string identityInWords(const PlaceIdentity& identity) {
  std::ostringstream text;
  text << std::hex << std::setfill('0');
  for (const std::uint8_t byte : identity) text << std::setw(2) << static_cast<int>(byte);
  return text.str();
}

std::string placesAsCsv(const MapSnapshot& map) {
  Text text;
  text << "id,identity,label,session,x,y,yaw,learned\n";
  for (const Place& place : map.places) {
    const Pose2d& pose = place.map_from_place;
    text << place.id << ',' << identityInWords(place.identity) << ','
         << support::csvField(place.label) << ',' << place.session << ',' << pose.x << ',' << pose.y
         << ',' << pose.yaw << ',' << std::fixed << std::setprecision(3) << seconds(place.learned)
         << std::defaultfloat << std::setprecision(kDigits) << '\n';
  }
  return text.str();
}

std::string linksAsCsv(const MapSnapshot& map) {
  Text text;
  text << "first,second,x,y,yaw,forward_succeeded,forward_failed,backward_succeeded,"
          "backward_failed\n";
  for (const PlaceLink& link : map.links) {
    const Pose2d& pose = link.first_from_second;
    text << link.first << ',' << link.second << ',' << pose.x << ',' << pose.y << ',' << pose.yaw
         << ',' << link.forward.succeeded << ',' << link.forward.failed << ','
         << link.backward.succeeded << ',' << link.backward.failed << '\n';
  }
  return text.str();
}

std::string mapAsGraphml(const MapSnapshot& map) {
  Text text;
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  const auto key = [&text](const char* name, const char* of, const char* type) {
    text << "  <key id=\"" << of << '_' << name << "\" for=\"" << of << "\" attr.name=\"" << name
         << "\" attr.type=\"" << type << "\"/>\n";
  };
  const auto data = [&text](const char* name, const char* of, const auto& value) {
    text << "      <data key=\"" << of << '_' << name << "\">" << value << "</data>\n";
  };
  for (const char* of : {"node", "edge"}) {
    for (const char* number : {"x", "y", "yaw"}) key(number, of, "double");
  }
  key("label", "node", "string");
  key("identity", "node", "string");
  key("session", "node", "long");
  key("succeeded", "edge", "long");
  key("failed", "edge", "long");
  text << "  <graph id=\"map\" edgedefault=\"undirected\">\n";
  for (const Place& place : map.places) {
    text << "    <node id=\"" << place.id << "\">\n";
    data("label", "node", escaped(place.label));
    data("identity", "node", identityInWords(place.identity));
    data("session", "node", place.session);
    data("x", "node", place.map_from_place.x);
    data("y", "node", place.map_from_place.y);
    data("yaw", "node", place.map_from_place.yaw);
    text << "    </node>\n";
  }
  for (const PlaceLink& link : map.links) {
    text << "    <edge source=\"" << link.first << "\" target=\"" << link.second << "\">\n";
    data("x", "edge", link.first_from_second.x);
    data("y", "edge", link.first_from_second.y);
    data("yaw", "edge", link.first_from_second.yaw);
    data("succeeded", "edge", link.forward.succeeded + link.backward.succeeded);
    data("failed", "edge", link.forward.failed + link.backward.failed);
    text << "    </edge>\n";
  }
  text << "  </graph>\n</graphml>\n";
  return text.str();
}

std::vector<std::string> exportMap(const MapSnapshot& map,
                                   const std::function<EvidenceGrid(PlaceId)>& grid_of,
                                   double cell_size, double prior, const std::string& folder) {
  const std::string places = folder + "/places";
  std::error_code error;
  fs::create_directories(places, error);
  if (!fs::is_directory(places)) {
    throw std::runtime_error("cannot make the folder " + places + ": " + error.message());
  }
  std::vector<std::string> files;
  write(folder + "/places.csv", placesAsCsv(map), files);
  write(folder + "/links.csv", linksAsCsv(map), files);
  write(folder + "/map.graphml", mapAsGraphml(map), files);
  FusedMapOptions options;
  options.most_places = map.places.size() + 1;
  FusedMap building(options, GridGeometry{cell_size});
  for (const Place& place : map.places) {
    const auto grid = std::make_shared<const EvidenceGrid>(grid_of(place.id));
    const double half = grid->geometry().halfWidth();
    writeImage(places, std::to_string(place.id), {kGridSize, kGridSize, grid->cells().data()},
               cell_size, place.map_from_place * Pose2d{-half, -half, 0.0}, prior, files);
    building.add(place, grid);
  }
  building.update();
  const FusedCells cells = building.cells();
  if (cells.evidence.empty()) return files;
  writeImage(folder, "building", {cells.columns, cells.rows, cells.evidence.data()},
             cells.resolution, {cells.left, cells.bottom, 0.0}, prior, files);
  return files;
}

}  // namespace place_memory::core
