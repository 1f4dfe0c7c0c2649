#include "config/parameter_reader.h"

#include <cmath>
#include <sstream>

namespace place_memory::config {
namespace {

// yaml-cpp's tag of a scalar in quotes.
constexpr char kQuoted[] = "!";

bool isPlain(const YAML::Node& node) { return node.IsScalar() && node.Tag() != kQuoted; }

// A text that YAML takes for another type unless it is in quotes.
bool isOtherType(const YAML::Node& node) {
  if (!isPlain(node)) return false;
  double number = 0.0;
  bool flag = false;
  return YAML::convert<double>::decode(node, number) || YAML::convert<bool>::decode(node, flag);
}

std::string shown(const YAML::Node& node) {
  if (node.IsNull()) return "nothing";
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  return node.IsSequence() ? "a list" : "a table";
}

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
  std::set<std::string> names_here;
  flatten(table, "", source, names_here);
}

void ParameterReader::flatten(const YAML::Node& node, const std::string& name,
                              const std::string& source, std::set<std::string>& names_here) {
  if (!node.IsMap()) {
    if (!names_here.insert(name).second) {
      problems_.push_back(name + " (" + source + "): is given twice");
    }
    entries_[name] = {node, source};
    return;
  }
  for (const auto& item : node) {
    if (!item.first.IsScalar()) {
      problems_.push_back(source + ": a name must be a text, not " + shown(item.first));
      continue;
    }
    const std::string prefix = name.empty() ? "" : name + "/";
    flatten(item.second, prefix + item.first.Scalar(), source, names_here);
  }
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
  double number = 0.0;
  if (!isPlain(entry.value) || !YAML::convert<double>::decode(entry.value, number)) {
    complain(name, entry, "must be a number");
    return false;
  }
  if (!std::isfinite(number) || !interval.contains(number)) {
    complain(name, entry, "must be in " + interval.toString());
    return false;
  }
  value = number;
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
  bool given = false;
  if (!isPlain(entry->value) || !YAML::convert<bool>::decode(entry->value, given)) {
    complain(name, *entry, "must be true or false");
    return;
  }
  value = given;
}

void ParameterReader::text(const std::string& name,
                           const std::function<std::string(const std::string&)>& check,
                           std::string& value) {
  const Entry* entry = find(name);
  if (entry == nullptr) return;
  if (!entry->value.IsScalar() || isOtherType(entry->value)) {
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
    if (!item.IsScalar() || isOtherType(item)) {
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

std::vector<std::string> ParameterReader::problems() const {
  std::vector<std::string> all = problems_;
  for (const auto& [name, entry] : entries_) {
    if (known_.count(name) > 0) continue;
    // A section whose parameters are all commented out.
    const auto next = known_.lower_bound(name + "/");
    const bool is_section =
        next != known_.end() && next->compare(0, name.size() + 1, name + "/") == 0;
    if (is_section && entry.value.IsNull()) continue;
    all.push_back(name + " (" + entry.source + "): " +
                  (is_section ? "is a table of parameters, not " + shown(entry.value)
                              : "is not a parameter"));
  }
  return all;
}

}  // namespace place_memory::config
