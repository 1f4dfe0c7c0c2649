#include "sim/scene/world_loader.h"

#include <fstream>
#include <iterator>
#include <set>

#include "sim/scene/scene.h"
#include "sim/scene/yaml_reader.h"

namespace place_memory::sim {

namespace {

constexpr double kHalfTurn = core::kPi;

class WorldParser {
 public:
  WorldParser(const YAML::Node& root, const std::string& origin)
      : root_(root, origin, "the world") {}

  World parse() {
    root_.expectOnly({"name", "materials", "walls", "posts", "boxes", "tables", "doors", "chairs",
                      "bicycles", "whiteboards", "places"});
    world_.name = root_.text("name");
    readMaterials();
    readFixtures();
    readMovables();
    readPlaces();
    return std::move(world_);
  }

 private:
  void readMaterials() {
    for (const auto& [name, reader] : root_.entries("materials", "a material")) {
      reader.expectOnly({"critical_angle", "strength", "mirror"});
      materials_[name] = {reader.number("critical_angle", 0.01, 1.5708),
                          reader.number("strength", 0.01, 1.0), reader.number("mirror", 0.0, 1.0)};
    }
  }

  void readFixtures() {
    for (const YamlReader& reader : root_.list("walls", "a wall")) {
      reader.expectOnly({"points", "material"});
      world_.walls.push_back({reader.points("points"), material(reader, "painted")});
    }
    for (const YamlReader& reader : root_.list("posts", "a post")) {
      reader.expectOnly({"at", "radius", "material"});
      world_.posts.push_back(
          {reader.point("at"), reader.number("radius", 0.005, 5.0), material(reader, "painted")});
    }
    for (const YamlReader& reader : root_.list("boxes", "a box")) {
      reader.expectOnly({"at", "yaw", "size", "material"});
      const Vec2 size = sizeOf(reader);
      world_.boxes.push_back({poseOf(reader), size.x, size.y, material(reader, "furniture")});
    }
    for (const YamlReader& reader : root_.list("tables", "a table")) {
      reader.expectOnly({"at", "yaw", "size"});
      const Vec2 size = sizeOf(reader);
      world_.tables.push_back({poseOf(reader), size.x, size.y});
    }
  }

  void readMovables() {
    for (const YamlReader& reader : root_.list("doors", "a door")) {
      reader.expectOnly({"name", "hinge", "latch", "swing", "open", "material"});
      const Door door{
          nameOf(reader, doors_),     reader.point("hinge"),
          reader.point("latch"),      reader.number("swing", -kHalfTurn, kHalfTurn, 1.5),
          reader.flag("open", false), material(reader, "wood")};
      if (norm(door.latch - door.hinge) < 0.1) reader.fail("a door must be at least 0.1 m wide");
      world_.doors.push_back(door);
    }
    for (const YamlReader& reader : root_.list("chairs", "a chair")) {
      reader.expectOnly({"name", "at", "yaw"});
      world_.chairs.push_back({nameOf(reader, chairs_), poseOf(reader)});
    }
    for (const YamlReader& reader : root_.list("bicycles", "a bicycle")) {
      reader.expectOnly({"name", "at", "yaw"});
      world_.bicycles.push_back({nameOf(reader, bicycles_), poseOf(reader)});
    }
    for (const YamlReader& reader : root_.list("whiteboards", "a whiteboard")) {
      reader.expectOnly({"name", "from", "to"});
      world_.whiteboards.push_back(
          {nameOf(reader, whiteboards_), reader.point("from"), reader.point("to")});
    }
  }

  void readPlaces() {
    const std::vector<YamlReader> readers = root_.list("places", "a place");
    std::set<std::string> labels;
    for (const YamlReader& reader : readers) {
      reader.expectOnly({"label", "at", "links"});
      const std::string label = reader.text("label");
      if (!labels.insert(label).second) reader.fail("place '" + label + "' is defined twice");
      world_.places.push_back({label, reader.point("at"), reader.texts("links")});
    }
    const Scene scene(world_);
    for (std::size_t i = 0; i < readers.size(); ++i) {
      const Place& place = world_.places[i];
      for (const std::string& link : place.links) {
        if (labels.count(link) == 0 || link == place.label) {
          readers[i].fail("place '" + place.label + "' links to '" + link +
                          "', which is no other place");
        }
      }
      if (!scene.isFree(place.position, kPlaceClearance)) {
        readers[i].fail("place '" + place.label + "' leaves no room for a robot");
      }
    }
  }

  Material material(const YamlReader& reader, const std::string& otherwise) const {
    const std::string name = reader.has("material") ? reader.text("material") : otherwise;
    const auto it = materials_.find(name);
    if (it == materials_.end()) reader.fail("material '" + name + "' is not defined");
    return it->second;
  }

  static core::Pose2d poseOf(const YamlReader& reader) {
    const Vec2 at = reader.point("at");
    return {at.x, at.y, reader.number("yaw", -2.0 * kHalfTurn, 2.0 * kHalfTurn, 0.0)};
  }

  static Vec2 sizeOf(const YamlReader& reader) {
    const Vec2 size = reader.point("size");
    if (size.x < 0.01 || size.y < 0.01) reader.fail("'size' must be at least 0.01 m each way");
    return size;
  }

  static std::string nameOf(const YamlReader& reader, std::set<std::string>& taken) {
    std::string name = reader.text("name");
    if (!taken.insert(name).second) reader.fail("the name '" + name + "' is used twice");
    return name;
  }

  YamlReader root_;
  World world_;
  MaterialTable materials_ = standardMaterials();
  std::set<std::string> doors_;
  std::set<std::string> chairs_;
  std::set<std::string> bicycles_;
  std::set<std::string> whiteboards_;
};

template <typename T>
void expectUniqueNames(const std::vector<T>& items, const std::string& world) {
  std::set<std::string> names;
  for (const T& item : items) {
    if (!names.insert(item.name).second) {
      throw WorldError(world + ": the name '" + item.name + "' is used twice");
    }
  }
}

}  // namespace

World parseWorld(const std::string& text, const std::string& origin) {
  try {
    return WorldParser(YAML::Load(text), origin).parse();
  } catch (const YAML::Exception& error) {
    throw WorldError(origin + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

World loadWorld(const std::string& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw WorldError(path + ":1: the file cannot be read");
  return parseWorld(text, path);
}

void validateWorld(const World& world, double clearance) {
  expectUniqueNames(world.doors, world.name);
  expectUniqueNames(world.chairs, world.name);
  const Scene scene(world);
  std::set<std::string> labels;
  for (const Place& place : world.places) {
    if (!labels.insert(place.label).second) {
      throw WorldError(world.name + ": place '" + place.label + "' is defined twice");
    }
    if (!scene.isFree(place.position, clearance)) {
      throw WorldError(world.name + ": place '" + place.label + "' leaves no room for a robot");
    }
  }
  for (const Place& place : world.places) {
    for (const std::string& link : place.links) {
      if (labels.count(link) == 0 || link == place.label) {
        throw WorldError(world.name + ": place '" + place.label + "' links to '" + link +
                         "', which is no other place");
      }
    }
  }
}

}  // namespace place_memory::sim
