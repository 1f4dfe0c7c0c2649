#include "sim/scene/yaml_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/scene/world_loader.h"

namespace place_memory::sim {

namespace {

std::string shown(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

YamlReader::YamlReader(const YAML::Node& node, std::string origin, std::string what)
    : node_(node), origin_(std::move(origin)), what_(std::move(what)) {
  if (!node_.IsMap()) failAt(node_, what_ + " must be a map of keys and values");
}

void YamlReader::failAt(const YAML::Node& node, const std::string& message) const {
  const int line = node.IsDefined() ? node.Mark().line : -1;
  throw WorldError(origin_ + ":" + std::to_string(std::max(line, 0) + 1) + ": " + message);
}

void YamlReader::fail(const std::string& message) const { failAt(node_, message); }

void YamlReader::expectOnly(std::initializer_list<const char*> known) const {
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) failAt(entry.first, what_ + ": a key must be a word");
    const std::string& key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      failAt(entry.first, what_ + " has an unknown key '" + key + "'");
    }
  }
}

bool YamlReader::has(const char* key) const { return node_[key].IsDefined(); }

YAML::Node YamlReader::required(const char* key) const {
  YAML::Node node = node_[key];
  if (!node.IsDefined() || node.IsNull()) fail(what_ + " lacks '" + key + "'");
  return node;
}

std::string YamlReader::text(const char* key) const {
  const YAML::Node node = required(key);
  if (!node.IsScalar() || node.Scalar().empty()) {
    failAt(node, what_ + ": '" + key + "' must be a word");
  }
  return node.Scalar();
}

bool YamlReader::flag(const char* key, bool otherwise) const {
  if (!has(key)) return otherwise;
  bool value = false;
  if (!YAML::convert<bool>::decode(node_[key], value)) {
    failAt(node_[key], what_ + ": '" + key + "' must be true or false");
  }
  return value;
}

double YamlReader::toNumber(const YAML::Node& node, const std::string& what, double low,
                            double high) const {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    failAt(node, what + " must be a finite number");
  }
  if (value < low || value > high) {
    failAt(node,
           what + " is " + shown(value) + ", must be in [" + shown(low) + ", " + shown(high) + "]");
  }
  return value;
}

double YamlReader::number(const char* key, double low, double high) const {
  return toNumber(required(key), what_ + ": '" + key + "'", low, high);
}

double YamlReader::number(const char* key, double low, double high, double otherwise) const {
  return has(key) ? number(key, low, high) : otherwise;
}

Vec2 YamlReader::toPoint(const YAML::Node& node, const std::string& what) const {
  if (!node.IsSequence() || node.size() != 2) failAt(node, what + " must be a point [x, y]");
  return {toNumber(node[0], what + " x", -kFarthest, kFarthest),
          toNumber(node[1], what + " y", -kFarthest, kFarthest)};
}

Vec2 YamlReader::point(const char* key) const {
  return toPoint(required(key), what_ + ": '" + key + "'");
}

std::vector<Vec2> YamlReader::points(const char* key) const {
  const YAML::Node node = required(key);
  const std::string what = what_ + ": '" + key + "'";
  if (!node.IsSequence() || node.size() < 2) failAt(node, what + " must list at least two points");
  std::vector<Vec2> points;
  for (const auto& item : node) points.push_back(toPoint(item, what));
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (norm(points[i] - points[i - 1]) < 1e-3) failAt(node[i], what + " repeats a point");
  }
  return points;
}

std::vector<std::string> YamlReader::texts(const char* key) const {
  std::vector<std::string> texts;
  if (!has(key)) return texts;
  const YAML::Node node = node_[key];
  if (!node.IsSequence()) failAt(node, what_ + ": '" + key + "' must be a list");
  for (const auto& item : node) {
    if (!item.IsScalar()) failAt(item, what_ + ": '" + key + "' must list words");
    texts.push_back(item.Scalar());
  }
  return texts;
}

std::vector<YamlReader> YamlReader::list(const char* key, const char* what) const {
  std::vector<YamlReader> readers;
  if (!has(key) || node_[key].IsNull()) return readers;
  const YAML::Node node = node_[key];
  if (!node.IsSequence()) failAt(node, what_ + ": '" + key + "' must be a list");
  for (const auto& item : node) readers.emplace_back(item, origin_, what);
  return readers;
}

std::vector<std::pair<std::string, YamlReader>> YamlReader::entries(const char* key,
                                                                    const char* what) const {
  std::vector<std::pair<std::string, YamlReader>> entries;
  if (!has(key) || node_[key].IsNull()) return entries;
  const YAML::Node node = node_[key];
  if (!node.IsMap()) failAt(node, what_ + ": '" + key + "' must be a map");
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) failAt(entry.first, what_ + ": a key must be a word");
    entries.emplace_back(entry.first.Scalar(), YamlReader(entry.second, origin_, what));
  }
  return entries;
}

}  // namespace place_memory::sim
