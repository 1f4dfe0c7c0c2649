#include "config/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/nearest_name.h"
#include "config/yaml_value.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

// More than any table of parameters has; tables that name others over and over grow beyond it.
constexpr std::size_t kMostValues = 1000;

}  // namespace

bool Interval::contains(double value) const {
  const bool above = low_closed ? value >= low : value > low;
  const bool below = high_closed ? value <= high : value < high;
  return above && below;
}

std::string Interval::toString() const {
  std::ostringstream text;
  text << (low_closed ? '[' : '(') << low << ", " << high << (high_closed ? ']' : ')');
  return text.str();
}

void ParameterReader::add(const YAML::Node& table, const std::string& source) {
  if (!table.IsDefined() || table.IsNull()) return;
  if (!table.IsMap()) {
    problems_.push_back(source + ": must be a table of parameters, not " + shown(table));
    return;
  }
  Descent descent;
  descent.source = source;
  flatten(table, "", descent);
}

void ParameterReader::flatten(const YAML::Node& node, const std::string& name, Descent& descent) {
  if (++descent.values > kMostValues) {
    if (descent.values == kMostValues + 1) {
      problems_.push_back(descent.source + ": has more parameters than there are");
    }
    return;
  }
  if (node.IsMap()) {
    const auto is_same = [&](const YAML::Node& table) { return table.is(node); };
    std::vector<YAML::Node>& containing = descent.containing;
    if (std::any_of(containing.begin(), containing.end(), is_same)) {
      problems_.push_back(name + " (" + descent.source + "): is a table that contains itself");
      return;
    }
    containing.push_back(node);
    flattenTable(node, name, descent);
    containing.pop_back();
    return;
  }
  if (!descent.names.insert(name).second) {
    problems_.push_back(name + " (" + descent.source + "): is given twice");
  }
  entries_[name] = {node, descent.source};
}

void ParameterReader::flattenTable(const YAML::Node& table, const std::string& name,
                                   Descent& descent) {
  std::set<std::string> own;
  std::vector<YAML::Node> merged;
  for (const auto& item : table) {
    if (!item.first.IsScalar()) {
      problems_.push_back(descent.source + ": a name must be a text, not " + shown(item.first));
      continue;
    }
    const std::string& key = item.first.Scalar();
    if (key == "<<") {
      merged.push_back(item.second);
      continue;
    }
    own.insert(key);
    flatten(item.second, name.empty() ? key : name + "/" + key, descent);
  }
  for (const YAML::Node& node : merged) merge(node, name, own, descent);
}

void ParameterReader::merge(const YAML::Node& merged, const std::string& name,
                            std::set<std::string>& own, Descent& descent) {
  if (merged.IsSequence()) {
    for (const YAML::Node& table : merged) {
      if (!table.IsSequence()) merge(table, name, own, descent);
    }
    return;
  }
  if (!merged.IsMap()) {
    problems_.push_back((name.empty() ? "" : name + "/") + "<< (" + descent.source +
                        "): must be a table, not " + shown(merged));
    return;
  }
  YAML::Node rest(YAML::NodeType::Map);
  for (const auto& item : merged) {
    if (!item.first.IsScalar() || own.insert(item.first.Scalar()).second) {
      rest.force_insert(item.first, item.second);
    }
  }
  const auto is_same = [&](const YAML::Node& table) { return table.is(merged); };
  std::vector<YAML::Node>& containing = descent.containing;
  if (std::any_of(containing.begin(), containing.end(), is_same)) {
    problems_.push_back(name + " (" + descent.source + "): is a table that contains itself");
    return;
  }
  containing.push_back(merged);
  flattenTable(rest, name, descent);
  containing.pop_back();
}

const ParameterReader::Entry* ParameterReader::find(const std::string& name) {
  known_.insert(name);
  const auto entry = entries_.find(name);
  return entry == entries_.end() ? nullptr : &entry->second;
}

void ParameterReader::complain(const std::string& name, const Entry& entry,
                               const std::string& problem) {
  problems_.push_back(name + " (" + entry.source + "): " + problem + ", not " + shown(entry.value));
}

bool ParameterReader::readNumber(const std::string& name, const Entry& entry,
                                 const Interval& interval, double& value) {
  const std::optional<double> number = numberOf(entry.value);
  if (!number) {
    complain(name, entry, "must be a number");
    return false;
  }
  if (!std::isfinite(*number) || !interval.contains(*number)) {
    complain(name, entry, "must be in " + interval.toString());
    return false;
  }
  value = *number;
  return true;
}

void ParameterReader::number(const std::string& name, const Interval& interval, double& value) {
  if (const Entry* entry = find(name)) readNumber(name, *entry, interval, value);
}

void ParameterReader::integer(const std::string& name, const Interval& interval, int& value) {
  const Entry* entry = find(name);
  double number = 0.0;
  if (entry == nullptr || !readNumber(name, *entry, interval, number)) return;
  if (number != std::floor(number)) {
    complain(name, *entry, "must be a whole number");
    return;
  }
  value = static_cast<int>(number);
}

void ParameterReader::flag(const std::string& name, bool& value) {
  const Entry* entry = find(name);
  if (entry == nullptr) return;
  const std::optional<bool> given = flagOf(entry->value);
  if (!given) {
    complain(name, *entry, "must be true or false");
    return;
  }
  value = *given;
}

bool ParameterReader::saysOff(const std::string& name) {
  const Entry* entry = find(name);
  if (entry == nullptr || kindOf(entry->value) != ValueKind::kFlag) return false;
  return flagOf(entry->value) == false;
}

void ParameterReader::text(const std::string& name,
                           const std::function<std::string(const std::string&)>& check,
                           std::string& value) {
  const Entry* entry = find(name);
  if (entry == nullptr) return;
  if (kindOf(entry->value) != ValueKind::kText) {
    complain(name, *entry, "must be a text");
    return;
  }
  const std::string problem = check(entry->value.Scalar());
  if (!problem.empty()) {
    complain(name, *entry, problem);
    return;
  }
  value = entry->value.Scalar();
}

void ParameterReader::texts(const std::string& name,
                            const std::function<std::string(const std::string&)>& check,
                            std::vector<std::string>& value) {
  const Entry* entry = find(name);
  if (entry == nullptr) return;
  if (!entry->value.IsSequence() || entry->value.size() == 0) {
    complain(name, *entry, "must be a list of one text or more");
    return;
  }
  std::vector<std::string> given;
  for (const YAML::Node& item : entry->value) {
    const Entry as_entry{item, entry->source};
    if (kindOf(item) != ValueKind::kText) {
      complain(name, as_entry, "must be a list of texts");
      return;
    }
    const std::string problem = check(item.Scalar());
    if (!problem.empty()) {
      complain(name, as_entry, problem);
      return;
    }
    given.push_back(item.Scalar());
  }
  value = given;
}

void ParameterReader::poses(const std::string& name, std::size_t most,
                            std::vector<core::Pose2d>& value) {
  const Entry* entry = find(name);
  if (entry == nullptr) return;
  if (!entry->value.IsSequence() || entry->value.size() > most) {
    complain(name, *entry,
             "must be a list of up to " + std::to_string(most) + " poses [x, y, yaw]");
    return;
  }
  std::vector<core::Pose2d> given;
  for (const YAML::Node& item : entry->value) {
    const std::optional<core::Pose2d> pose = poseOf(item);
    if (!pose) {
      complain(name, {item, entry->source}, "each must be [x, y, yaw], of numbers up to 100");
      return;
    }
    given.push_back(*pose);
  }
  value = given;
}

std::string ParameterReader::unknown(const std::string& name, const Entry& entry) const {
  const std::string where = support::printable(name) + " (" + entry.source + "): ";
  const auto now = renamed_.find(name);
  if (now != renamed_.end()) return where + "is called " + now->second + " now";
  const std::string word = name.substr(name.find_last_of('/') + 1);
  // What a decimal comma leaves of {step: 0,03}.
  if (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos) {
    return where + "is not a parameter; decimals have a point, not a comma";
  }
  const std::string meant = nearestName(name, known_);
  return where + "is not a parameter" + (meant.empty() ? "" : "; is " + meant + " meant?");
}

std::vector<std::string> ParameterReader::problems() const {
  std::vector<std::string> all = problems_;
  for (const auto& [name, entry] : entries_) {
    if (known_.count(name) > 0) continue;
    // A section whose parameters are all commented out.
    const auto next = known_.lower_bound(name + "/");
    const bool is_section =
        next != known_.end() && next->compare(0, name.size() + 1, name + "/") == 0;
    if (is_section && entry.value.IsNull()) continue;
    all.push_back(is_section ? name + " (" + entry.source + "): is a table of parameters, not " +
                                   shown(entry.value)
                             : unknown(name, entry));
  }
  return all;
}

}  // namespace place_memory::config
