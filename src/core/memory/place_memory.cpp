#include "place_memory/core/place_memory.h"

#include <cmath>
#include <utility>

#include "core/map/place_label.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;

// Runs a change or a query of the store, and reports its failure as the memory's.
template <typename Call>
auto onStore(const Call& call) {
  try {
    return call();
  } catch (const StoreError& error) {
    throw PlaceMemoryError(Reason::kStoreFailed, error.what());
  }
}

[[noreturn]] void refuseLabel() {
  throw PlaceMemoryError(Reason::kInvalidLabel,
                         "a label has 1 to " + std::to_string(kMaxLabelBytes) +
                             " bytes of UTF-8 text without control characters");
}

}  // namespace

PlaceMemory::PlaceMemory(const PlaceMemoryOptions& options)
    : cell_size_(options.cell_size),
      recognizer_(options.recognizer),
      adaptation_(options.adaptation),
      sonar_(options.sonar),
      store_(options.store_path, options.cell_size, options.opening),
      graph_(store_.graph()) {
  // Written so that NaN fails.
  if (!(adaptation_.retention >= 0.0 && adaptation_.retention < 1.0)) {
    throw std::invalid_argument("adaptation retention must lie in [0, 1)");
  }
  store_.forEachPlanes([this](PlaceId id, const CellPlanes& planes) { index_.put(id, planes); });
}

Place PlaceMemory::learn(const Scan& scan, const std::string& label) {
  if (std::abs(scan.grid.geometry().cell_size - cell_size_) > 1e-9) {
    throw PlaceMemoryError(Reason::kInvalidScan,
                           "the scan has cells of " +
                               std::to_string(scan.grid.geometry().cell_size) +
                               " m, the memory's are " + std::to_string(cell_size_) + " m");
  }
  if (!scan.odom_from_scan.isFinite()) {
    throw PlaceMemoryError(Reason::kInvalidScan, "the location of the scan is not finite");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  Place place;
  place.label = newLabelLocked(label);
  place.map_from_place = scan.odom_from_scan;
  place.learned = scan.end;
  place.id = onStore([&] { return store_.add(place, scan.grid, previous_); });
  graph_.add(place);
  if (previous_ != kNoPlace) graph_.link(previous_, place.id);
  index_.put(place.id, scan.grid);
  previous_ = place.id;
  newest_answer_ = ++questions_;
  return place;
}

LabelledRecognition PlaceMemory::recognize(const Scan& scan, double heading_window,
                                           const std::function<bool()>& cancelled) {
  std::uint64_t question = 0;
  for (;;) {
    PlaceIndex snapshot;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      snapshot = index_;
      if (question == 0) question = ++questions_;
    }
    const auto frames = [this](const std::vector<PlaceId>& places) { return framesOf(places); };
    auto found = recognizer_.recognize(scan, snapshot, frames, heading_window, cancelled);
    if (!found) continue;
    Recognition& recognition = *found;
    const std::lock_guard<std::mutex> lock(mutex_);
    // The verdict and the probabilities weighed every match, so one of a place that is gone by now
    // cannot just be left out.
    auto labels = labelsLocked(recognition.matches);
    if (!labels) continue;
    const bool superseded = question < newest_answer_;
    if (!superseded) {
      newest_answer_ = question;
      if (recognition.verdict == Verdict::kRecognized) previous_ = recognition.matches.front().id;
    }
    return {std::move(recognition), std::move(*labels), superseded};
  }
}

bool PlaceMemory::adapt(const Scan& scan, const Recognition& recognition) {
  if (!adaptation_.enabled || recognition.verdict != Verdict::kRecognized) return false;
  const PlaceMatch& match = recognition.matches.front();
  const EvidenceGrid sensed =
      sonar_.build(movedReadings(scan.readings, match.place_from_scan), GridGeometry{cell_size_});
  const std::lock_guard<std::mutex> lock(mutex_);
  const Place* place = graph_.find(match.id);
  // Evidence that is already in the grid is no further evidence.
  if (place == nullptr || place->learned == scan.end || last_folded_ == scan.end) return false;
  onStore([&] {
    EvidenceGrid grid = store_.grid(match.id);
    fuse(sensed, adaptation_.retention, grid);
    store_.update(match.id, grid);
    index_.put(match.id, grid);
  });
  last_folded_ = scan.end;
  return true;
}

void PlaceMemory::rename(const std::string& label, const std::string& new_label) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const PlaceId id = findLocked(label).id;
  if (new_label.empty()) refuseLabel();
  if (new_label == label) return;
  const std::string checked = newLabelLocked(new_label);
  onStore([&] { store_.rename(id, checked); });
  graph_.rename(id, checked);
}

void PlaceMemory::remove(const std::string& label) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const PlaceId id = findLocked(label).id;
  onStore([&] { store_.remove(id); });
  graph_.remove(id);
  index_.erase(id);
  if (previous_ == id) previous_ = kNoPlace;
}

std::size_t PlaceMemory::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t places = graph_.size();
  onStore([&] { store_.clear(); });
  graph_.clear();
  index_.clear();
  previous_ = kNoPlace;
  newest_answer_ = ++questions_;
  return places;
}

std::size_t PlaceMemory::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return graph_.size();
}

PlaceGraph PlaceMemory::graph() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return graph_;
}

std::optional<Place> PlaceMemory::place(PlaceId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Place* place = graph_.find(id);
  return place == nullptr ? std::nullopt : std::optional<Place>(*place);
}

EvidenceGrid PlaceMemory::grid(PlaceId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (graph_.find(id) == nullptr) {
    throw PlaceMemoryError(Reason::kUnknownPlace, "there is no place " + std::to_string(id));
  }
  return onStore([&] { return store_.grid(id); });
}

std::optional<Place> PlaceMemory::previousPlace() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Place* place = graph_.find(previous_);
  return place == nullptr ? std::nullopt : std::optional<Place>(*place);
}

void PlaceMemory::forgetPreviousPlace() {
  const std::lock_guard<std::mutex> lock(mutex_);
  previous_ = kNoPlace;
  newest_answer_ = ++questions_;
}

std::optional<std::vector<PlaceFrame>> PlaceMemory::framesOf(
    const std::vector<PlaceId>& places) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<PlaceFrame> frames;
  frames.reserve(places.size());
  for (const PlaceId id : places) {
    const Place* place = graph_.find(id);
    if (place == nullptr) return std::nullopt;
    frames.push_back({place->map_from_place});
  }
  return frames;
}

const Place& PlaceMemory::findLocked(const std::string& label) const {
  const Place* place = graph_.find(label);
  if (place == nullptr) {
    // What is no label is not repeated: it may be too long or too broken to be shown.
    throw PlaceMemoryError(Reason::kUnknownPlace, isValidLabel(label)
                                                      ? "there is no place \"" + label + "\""
                                                      : "there is no place with that label");
  }
  return *place;
}

std::string PlaceMemory::newLabelLocked(const std::string& wanted) const {
  if (!wanted.empty()) {
    if (!isValidLabel(wanted)) refuseLabel();
    if (graph_.find(wanted) != nullptr) {
      throw PlaceMemoryError(Reason::kLabelTaken,
                             "another place has the label \"" + wanted + "\"; give another one");
    }
    return wanted;
  }
  PlaceId number = graph_.lastId() + 1;
  std::string label = "place " + std::to_string(number);
  while (graph_.find(label) != nullptr) label = "place " + std::to_string(++number);
  return label;
}

std::optional<std::vector<std::string>> PlaceMemory::labelsLocked(
    const std::vector<PlaceMatch>& matches) const {
  std::vector<std::string> labels;
  labels.reserve(matches.size());
  for (const PlaceMatch& match : matches) {
    const Place* place = graph_.find(match.id);
    if (place == nullptr) return std::nullopt;
    labels.push_back(place->label);
  }
  return labels;
}

}  // namespace place_memory::core
