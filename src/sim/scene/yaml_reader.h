#ifndef PLACE_MEMORY_SIM_SCENE_YAML_READER_H
#define PLACE_MEMORY_SIM_SCENE_YAML_READER_H

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "sim/world/vec2.h"

namespace place_memory::sim {

/// A YAML map read strictly: what is asked for must be there, well typed and in range, and nothing
/// else may be there. All errors are WorldErrors that begin with file and line.
class YamlReader {
 public:
  YamlReader(const YAML::Node& node, std::string origin, std::string what);

  /// Refuses keys outside `known`.
  void expectOnly(std::initializer_list<const char*> known) const;

  bool has(const char* key) const;
  std::string text(const char* key) const;
  bool flag(const char* key, bool otherwise) const;
  double number(const char* key, double low, double high) const;
  double number(const char* key, double low, double high, double otherwise) const;
  Vec2 point(const char* key) const;
  std::vector<Vec2> points(const char* key) const;
  std::vector<std::string> texts(const char* key) const;

  /// The maps listed under `key`, each called `what` in errors; none where the key is absent.
  std::vector<YamlReader> list(const char* key, const char* what) const;

  /// Name and value of each entry of the map under `key`.
  std::vector<std::pair<std::string, YamlReader>> entries(const char* key, const char* what) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  YAML::Node required(const char* key) const;
  double toNumber(const YAML::Node& node, const std::string& what, double low, double high) const;
  Vec2 toPoint(const YAML::Node& node, const std::string& what) const;
  [[noreturn]] void failAt(const YAML::Node& node, const std::string& message) const;

  YAML::Node node_;
  std::string origin_;
  std::string what_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_YAML_READER_H
