// Draws a world or a generated building as it truly is.

#include <algorithm>
#include <boost/program_options.hpp>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "picture/picture.h"
#include "picture/scale_bar.h"
#include "sim/building/building_generator.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_loader.h"
#include "trials/lab_program.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

constexpr picture::Color kWall{25, 30, 60};
constexpr picture::Color kPlace{32, 96, 192};
constexpr double kWidth = 0.12;   // of walls [m]
constexpr double kRadius = 0.2;   // of places [m]
constexpr double kMargin = 1.5;   // [m]
constexpr double kLetters = 0.6;  // [m]
constexpr int kPixels = 1400;

picture::Point toPoint(const sim::Vec2& at) { return {at.x, at.y}; }

void include(const picture::Point& at, picture::Picture& picture) {
  picture.lower_left = {std::min(picture.lower_left.x, at.x - kMargin),
                        std::min(picture.lower_left.y, at.y - kMargin)};
  picture.upper_right = {std::max(picture.upper_right.x, at.x + kMargin),
                         std::max(picture.upper_right.y, at.y + kMargin)};
}

picture::Picture draw(const sim::World& world) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  picture::Picture picture{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}, {255, 255, 255}, {}};
  const sim::Scene scene(world);
  for (const sim::Segment& segment : scene.segments()) {
    const picture::Point a = toPoint(segment.a), b = toPoint(segment.b);
    include(a, picture);
    include(b, picture);
    picture.shapes.emplace_back(picture::Line{{a, b}, kWidth, kWall});
  }
  for (const sim::Circle& circle : scene.circles()) {
    include(toPoint(circle.center), picture);
    picture.shapes.emplace_back(picture::Disc{toPoint(circle.center), circle.radius, kWall, ""});
  }
  for (const sim::Place& place : world.places) {
    picture.shapes.emplace_back(
        picture::Disc{toPoint(place.position), kRadius, kPlace, place.label});
  }
  if (!(picture.lower_left.x < picture.upper_right.x)) {
    throw std::runtime_error("there is nothing in the world that could be drawn");
  }
  picture::addScaleBar(picture, kLetters);
  return picture;
}

int run(const po::variables_map& given) {
  const sim::World world =
      given.count("world")
          ? sim::loadWorld(given["world"].as<std::string>())
          : sim::generateBuilding(static_cast<sim::BuildingKind>(given["kind"].as<int>()),
                                  given["seed"].as<std::uint64_t>());
  const std::string path = given["out"].as<std::string>();
  std::ofstream file(path, std::ios::binary);
  file << picture::toPng(draw(world), kPixels);
  file.close();
  if (!file) throw std::runtime_error("cannot write the picture " + path);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  po::options_description options("usage: place_memory_draw_world --out F.png");
  options.add_options()("help", "show this")("out", po::value<std::string>()->required(),
                                             "file to write")(
      "world", po::value<std::string>(), "world file; without it, a generated building")(
      "kind", po::value<int>()->default_value(0), "of that building, by its number")(
      "seed", po::value<std::uint64_t>()->default_value(1), "of that building");
  return place_memory::trials::runProgram("place_memory_draw_world", argc, argv, options, run);
}
