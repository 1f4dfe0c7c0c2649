#include "tools/bag_set.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tools/bag_merge.h"

namespace place_memory::tools {
namespace {

// Bags in a row end and begin so near to each other.
constexpr double kGap = 1.0;

}  // namespace

BagSet::BagSet(const std::vector<std::string>& paths, const std::vector<std::string>& topics) {
  std::set<std::string> read = {"tf", "tf_static"};
  for (const std::string& topic : topics) read.insert(withoutSlash(topic));
  for (const std::string& path : paths) sources_.push_back(openSource(path, read));
  for (const BagSource& source : sources_) {
    for (const auto& [topic, types] : source.types) {
      types_[topic].insert(types.begin(), types.end());
    }
  }
  std::stable_sort(sources_.begin(), sources_.end(), [](const BagSource& a, const BagSource& b) {
    return a.clock.first < b.clock.first;
  });
}

std::string BagSet::name() const {
  if (sources_.size() == 1) return "the bag " + sources_.front().path;
  std::string text = "the bags ";
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (i > 0) text += i + 1 == sources_.size() ? " and " : ", ";
    text += sources_[i].path;
  }
  return text;
}

ros::Time BagSet::first() const { return sources_.front().clock.first; }

ros::Time BagSet::last() const {
  ros::Time last = sources_.front().clock.last;
  for (const BagSource& source : sources_) last = std::max(last, source.clock.last);
  return last;
}

std::string BagSet::missing(const ros::Time& start, const ros::Time& end) const {
  const std::string holds = sources_.size() == 1 ? "the bag holds" : "the bags hold";
  const std::string all = " what " + holds + ", which is from " +
                          inWords(first().toSec(), "%.3f to ") + inWords(last().toSec(), "%.3f s");
  if (end < first()) return "it lies before" + all;
  if (start > last()) return "it lies after" + all;
  const auto holds_some = [&](const BagSource& source) {
    return start <= source.clock.last && end >= source.clock.first;
  };
  if (std::any_of(sources_.begin(), sources_.end(), holds_some)) return {};
  return "it lies in a gap between the bags";
}

std::vector<std::string> BagSet::notes() const {
  std::vector<std::string> notes;
  for (const BagSource& source : sources_) {
    notes.insert(notes.end(), source.notes.begin(), source.notes.end());
  }
  noteNeighbours(notes);
  return notes;
}

void BagSet::noteNeighbours(std::vector<std::string>& notes) const {
  const BagSource* before = &sources_.front();
  for (const BagSource& source : sources_) {
    if (&source == before) continue;
    const double gap = source.clock.first.toSec() - before->clock.last.toSec();
    if (gap > kGap) {
      notes.push_back("between the bags " + before->path + " and " + source.path +
                      " lies a gap of " + inWords(gap));
    } else if (gap < 0.0) {
      const ros::Time end = std::min(before->clock.last, source.clock.last);
      notes.push_back("the bags " + before->path + " and " + source.path + " overlap by " +
                      inWords(end.toSec() - source.clock.first.toSec()) +
                      ": what both hold is taken once");
    }
    if (source.clock.last > before->clock.last) before = &source;
  }
}

void BagSet::read(const std::set<std::string>& topics, const ros::Time& start, const ros::Time& end,
                  const Visitor& visit) const {
  std::vector<StampOrder> orders;
  for (const BagSource& source : sources_) {
    const std::vector<std::string> names = source.namesOf(topics);
    if (names.empty()) continue;
    orders.emplace_back(*source.bag, names, source.clock, source.layouts, start, end);
  }
  BagMerge merge(std::move(orders));
  while (const auto timed = merge.next()) visit(*timed);
}

void BagSet::readAll(const std::string& topic, const Visitor& visit) const try {
  read({topic}, ros::TIME_MIN, ros::TIME_MAX, visit);
} catch (const std::exception& error) {  // of rosbag, and of what decompresses
  throw std::runtime_error(name() + (isOne() ? " is" : " are") + " damaged: " + error.what());
}

}  // namespace place_memory::tools
