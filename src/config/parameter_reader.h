#ifndef PLACE_MEMORY_CONFIG_PARAMETER_READER_H
#define PLACE_MEMORY_CONFIG_PARAMETER_READER_H

#include <yaml-cpp/yaml.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/pose2d.h"

namespace place_memory::config {

/// Values a number may have: between the bounds, which count if they are closed.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  bool low_closed = true;
  bool high_closed = true;

  bool contains(double value) const;
  std::string toString() const;  ///< as "(0, 0.5]"
};

/// Reads parameters out of tables of tables, each named by its path, as "scan/step". What is wrong
/// is noted and the value left as it was, so that all problems are found in one go.
class ParameterReader {
 public:
  /// Adds the parameters of a table on top of those added before. `source` tells a person where
  /// they stand. Keys `<<` merge tables as YAML 1.1 has it.
  void add(const YAML::Node& table, const std::string& source);

  /// Old names with the new ones, which problems() names where an old one is given.
  void renamed(const std::map<std::string, std::string>& names) { renamed_ = names; }

  bool has(const std::string& name) const { return entries_.count(name) != 0; }

  void number(const std::string& name, const Interval& interval, double& value);
  void integer(const std::string& name, const Interval& interval, int& value);
  void flag(const std::string& name, bool& value);
  /// `check` returns what is wrong with a text, or an empty string.
  void text(const std::string& name, const std::function<std::string(const std::string&)>& check,
            std::string& value);
  void texts(const std::string& name, const std::function<std::string(const std::string&)>& check,
             std::vector<std::string>& value);

  /// Poses, each [x, y, yaw] with [m, m, rad]; `most` at the most.
  void poses(const std::string& name, std::size_t most, std::vector<core::Pose2d>& value);

  template <class Value>
  void choice(const std::string& name, const std::vector<std::pair<std::string, Value>>& choices,
              Value& value) {
    if (saysOff(name)) {
      for (const auto& [known, meaning] : choices) {
        if (known != "off") continue;
        value = meaning;
        return;
      }
    }
    std::string words;
    for (const auto& choice : choices) words += (words.empty() ? "" : ", ") + choice.first;
    std::string word;
    text(
        name,
        [&](const std::string& given) {
          for (const auto& [known, meaning] : choices) {
            if (known == given) return std::string();
          }
          return "must be one of " + words;
        },
        word);
    for (const auto& [known, meaning] : choices) {
      if (known == word) value = meaning;
    }
  }

  /// Names asked for so far.
  const std::set<std::string>& known() const { return known_; }

  /// Everything that was wrong, in the order in which it was found; parameters nobody asked for
  /// come last.
  std::vector<std::string> problems() const;

 private:
  struct Entry {
    YAML::Node value;
    std::string source;
  };

  /// One table on its way into entries_.
  struct Descent {
    std::string source;
    std::size_t values = 0;              ///< seen in it, those of tables named often each time
    std::set<std::string> names;         ///< found in it
    std::vector<YAML::Node> containing;  ///< the tables that are being read, the outermost first
  };

  void flatten(const YAML::Node& node, const std::string& name, Descent& descent);
  void flattenTable(const YAML::Node& table, const std::string& name, Descent& descent);
  /// Adds what the key `<<` names, but for `own` keys.
  void merge(const YAML::Node& merged, const std::string& name, std::set<std::string>& own,
             Descent& descent);
  std::string unknown(const std::string& name, const Entry& entry) const;
  const Entry* find(const std::string& name);
  /// Whether the value is a bare off, which YAML 1.1 takes for false.
  bool saysOff(const std::string& name);
  void complain(const std::string& name, const Entry& entry, const std::string& problem);
  bool readNumber(const std::string& name, const Entry& entry, const Interval& interval,
                  double& value);

  std::map<std::string, Entry> entries_;
  std::set<std::string> known_;
  std::map<std::string, std::string> renamed_;
  std::vector<std::string> problems_;
};

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_PARAMETER_READER_H
