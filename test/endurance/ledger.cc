#include "endurance/ledger.h"

#include <algorithm>
#include <set>

namespace place_memory {
namespace {

using What = Said::What;

std::multiset<std::string> labelsOf(const MapRecord& map) {
  std::multiset<std::string> labels;
  for (const core::Place& place : map.places) labels.insert(place.label);
  return labels;
}

/// Of labels that it names.
bool isOfLabels(Deed deed) {
  return deed == Deed::kLearn || deed == Deed::kRename || deed == Deed::kRemove ||
         deed == Deed::kClear;
}

}  // namespace

void Ledger::add(const Said& said) {
  switch (said.what) {
    case What::kOpened:
      open(said.map);
      break;
    case What::kChanged:
      if (said.map.version != map_.version + 1) {
        problems_.push_back("version " + std::to_string(said.map.version) + " was told after " +
                            std::to_string(map_.version));
      }
      map_ = said.map;
      if (map_.places.empty()) {
        for (const auto& [client, asked] : asked_) cleared_.insert(client);
      }
      break;
    case What::kAsked:
      if (said.deed == Deed::kSave) saved_.push_back(labelsOf(map_));
      asked_[said.client] = said;
      cleared_.erase(said.client);
      break;
    case What::kAnswered:
      acknowledge(said);
      asked_.erase(said.client);
      break;
    case What::kDeclined:
      asked_.erase(said.client);
      break;
    case What::kFailed:
      problems_.push_back(said.text);
      break;
  }
}

void Ledger::open(const MapRecord& found) {
  ++openings_;
  if (!(found == map_)) {
    if (isOneMore(found)) {
      ++untold_;
    } else {
      problems_.push_back("lost: " + difference(map_, found));
    }
  }
  map_ = found;
  asked_.clear();
}

// A deed of a client's own places stays done until somebody clears the map.
void Ledger::acknowledge(const Said& said) {
  ++acknowledged_;
  const bool is_cleared = cleared_.count(said.client) > 0;
  const bool is_there = is_cleared || (said.deed == Deed::kLearn && has(said.text)) ||
                        (said.deed == Deed::kRename && has(said.new_text)) ||
                        (said.deed == Deed::kRemove && !has(said.text)) || !isOfLabels(said.deed);
  if (!is_there) problems_.push_back("acknowledged, and not told: \"" + said.text + "\"");
}

bool Ledger::isOneMore(const MapRecord& found) const {
  if (found.version != map_.version + 1) return false;
  return std::any_of(asked_.begin(), asked_.end(),
                     [&](const auto& client) { return explains(client.second, found); });
}

bool Ledger::explains(const Said& asked, const MapRecord& found) const {
  std::multiset<std::string> labels = labelsOf(map_);
  const std::multiset<std::string> now = labelsOf(found);
  // Learning and recognizing may move the places of a session, too.
  const bool may_move = asked.deed == Deed::kLearn || asked.deed == Deed::kRecognize;
  if (may_move && labels == now) return true;
  switch (asked.deed) {
    case Deed::kLearn:
      labels.insert(asked.text);
      break;
    case Deed::kRename:
      labels.erase(asked.text);
      labels.insert(asked.new_text);
      break;
    case Deed::kRemove:
      labels.erase(asked.text);
      break;
    case Deed::kClear:
      labels.clear();
      break;
    case Deed::kRecognize:
    case Deed::kRelax:
    case Deed::kTraverse:
    case Deed::kSetLink:
      break;
    case Deed::kSave:
      return false;
    case Deed::kLoad:
      return std::find(saved_.begin(), saved_.end(), now) != saved_.end();
    case Deed::kDrive:
    case Deed::kMerge:  // which adds, and takes nothing
      return std::includes(now.begin(), now.end(), labels.begin(), labels.end());
    case Deed::kUndo:
      return true;  // what it takes back may be anything
  }
  return labels == now;
}

bool Ledger::has(const std::string& label) const {
  return std::any_of(map_.places.begin(), map_.places.end(),
                     [&](const core::Place& place) { return place.label == label; });
}

}  // namespace place_memory
