#ifndef PLACE_MEMORY_TEST_ENDURANCE_BUSY_CLIENT_H
#define PLACE_MEMORY_TEST_ENDURANCE_BUSY_CLIENT_H

#include <unistd.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/map/kept_map.h"
#include "core/random_room.h"
#include "endurance/busy_memory.h"
#include "endurance/change_log.h"
#include "place_memory/core/place_memory.h"

namespace place_memory {

/// Does one deed after the other to places that no other client touches, but for clear().
class BusyClient {
 public:
  BusyClient(core::PlaceMemory& memory, ChangeLog& log, unsigned number, const BusyMemory& busy)
      : memory_(memory),
        log_(log),
        number_(number),
        saved_(busy.saved),
        is_alone_(busy.clients == 1),
        random_(busy.seed * 64 + number) {}

  void work() {
    for (;;) {
      const std::vector<std::string> own = ownLabels();
      switch (random_() % 16) {
        case 0:
        case 1:
        case 2:
          if (memory_.size() < kMostPlaces) {
            learn();
          } else {
            remove(own);
          }
          break;
        case 3:
        case 4:
          recognize(own);
          break;
        case 5:
          rename(own);
          break;
        case 6:
          if (number_ == 0) relax();  // one robot drives
          break;
        case 7:
          traverse();
          break;
        case 8:
          if (is_alone_) undo();
          break;
        case 9:
        case 10:
          setLink();
          break;
        case 11:
          if (is_alone_) drive();
          break;
        case 12:
          if (number_ == 0) save();
          break;
        case 13:
          if (is_alone_) takeIn();
          break;
        default:
          if (random_() % kDeedsBetweenClears == 0) {
            clear();
          } else {
            remove(own);
          }
      }
    }
  }

 private:
  using PlaceMemory = core::PlaceMemory;
  using PlaceMemoryError = core::PlaceMemoryError;
  using What = Said::What;

  // So that every change can be said with the whole map.
  static constexpr std::size_t kMostPlaces = 24;
  static constexpr double kHeadingWindow = 0.3;
  static constexpr unsigned kDeedsBetweenClears = 50;

  // "1 77": of client 1, and of the room with seed 77; a third word tells renamed ones apart.
  std::string prefix() const { return std::to_string(number_) + " "; }

  std::vector<std::string> ownLabels() const {
    std::vector<std::string> own;
    for (const core::Place& place : memory_.map().places) {
      if (place.label.rfind(prefix(), 0) == 0) own.push_back(place.label);
    }
    return own;
  }

  core::Scan scanOf(unsigned room, const core::Pose2d& from) {
    core::Scan scan = core::RandomRoom(room).scanFrom(from);
    const auto place = [this] { return 0.1 * static_cast<double>(random_() % 100); };
    scan.odom_from_scan = {place(), place(), 0.0};
    scan.end = std::chrono::nanoseconds(random_());
    return scan;
  }

  void learn() {
    const unsigned room = static_cast<unsigned>(random_() % 1000000);
    const std::string label = prefix() + std::to_string(room);
    const core::Scan scan = scanOf(room, {});
    attempt(Deed::kLearn, label, "", [&] { memory_.learn(scan, label, true); });
  }

  void recognize(const std::vector<std::string>& own) {
    if (own.empty()) return learn();
    const std::string label = anyOf(own);
    const auto room = static_cast<unsigned>(std::stoul(label.substr(prefix().size())));
    const core::Scan scan = scanOf(room, {0.05, -0.05, 0.02});
    attempt(Deed::kRecognize, label, "", [&] { memory_.recognize(scan, kHeadingWindow); });
  }

  void rename(const std::vector<std::string>& own) {
    if (own.empty()) return learn();
    const std::string label = anyOf(own);
    const std::string room = label.substr(0, label.find(' ', prefix().size()));
    const std::string renamed = room + " " + std::to_string(random_() % 1000000);
    attempt(Deed::kRename, label, renamed, [&] { memory_.rename(label, renamed); });
  }

  void remove(const std::vector<std::string>& own) {
    if (own.empty()) return learn();
    const std::string label = anyOf(own);
    attempt(Deed::kRemove, label, "", [&] { memory_.remove(label); });
  }

  void relax() {
    attempt(Deed::kRelax, "", "", [&] {
      core::KeptMap map = memory_.drivenMap();
      for (core::ScanNode& node : map.nodes) {
        node.pose = core::Pose2d{0.01, -0.02, 0.003} * node.pose;
      }
      memory_.keep(map);
    });
  }

  void traverse() {
    const std::vector<core::PlaceLink> links = memory_.map().links;
    if (links.empty()) return learn();
    const core::PlaceLink& link = links[random_() % links.size()];
    core::Traversal traversal;
    traversal.from = link.second;
    traversal.to = link.first;
    traversal.begin = std::chrono::seconds(1000 + random_() % 1000);
    traversal.end = traversal.begin + std::chrono::seconds(1 + random_() % 100);
    traversal.succeeded = random_() % 3 != 0;
    attempt(Deed::kTraverse, "", "", [&] { memory_.reportTraversal(traversal); });
  }

  void setLink() {
    static constexpr core::LinkOrder kOrders[] = {core::LinkOrder::kBlock,
                                                  core::LinkOrder::kUnblock,
                                                  core::LinkOrder::kForbid, core::LinkOrder::kToll};
    const std::vector<core::PlaceLink> links = memory_.map().links;
    if (links.empty()) return learn();
    const core::PlaceLink& link = links[random_() % links.size()];
    const core::LinkOrder order = kOrders[random_() % std::size(kOrders)];
    const auto toll = static_cast<double>(random_() % 100);
    const bool both_ways = random_() % 2 == 0;
    attempt(Deed::kSetLink, "", "",
            [&] { memory_.setLink(link.second, link.first, order, toll, both_ways); });
  }

  // By way of a scan that is no place.
  void drive() {
    if (memory_.size() >= kMostPlaces) return removeDriven();
    const bool moves_others = random_() % 2 == 0;
    attempt(Deed::kDrive, "", "", [&] {
      core::KeptMap map = memory_.drivenMap();
      map.nodes.push_back(nodeAfter(map, core::kNoPlace));
      map.nodes.push_back(nodeAfter(map, map.next_place));
      if (!moves_others) return memory_.keepNewPlaces(map);
      map.nodes.front().pose = core::Pose2d{0.02, 0.0, -0.01} * map.nodes.front().pose;
      memory_.keep(map);
    });
  }

  core::ScanNode nodeAfter(const core::KeptMap& map, core::PlaceId place) {
    core::ScanNode node;
    node.session = 1;
    node.stamp = std::chrono::nanoseconds(random_());
    node.place = place;
    node.readings = std::make_shared<const std::vector<core::SonarReading>>(
        scanOf(static_cast<unsigned>(random_() % 1000000), {}).readings);
    if (map.nodes.empty()) return node;
    node.before = map.nodes.size() - 1;
    // What no place tells of has none.
    if (map.nodes.back().session > 0) node.session = map.nodes.back().session;
    node.motion = {0.6, 0.1, 0.2};
    node.pose = map.nodes.back().pose * node.motion;
    return node;
  }

  void removeDriven() {
    for (const core::Place& place : memory_.map().places) {
      if (place.label.rfind("place_", 0) != 0) continue;
      return attempt(Deed::kRemove, place.label, "", [&] { memory_.remove(place.label); });
    }
  }

  void save() {
    attempt(Deed::kSave, "", "", [&] { memory_.save(saved_); });
  }

  void takeIn() {
    if (!std::filesystem::exists(saved_)) return save();
    if (random_() % 2 == 0) {
      attempt(Deed::kLoad, "", "", [&] { memory_.load(saved_); });
    } else {
      attempt(Deed::kMerge, "", "", [&] { memory_.merge(saved_); });
    }
  }

  void undo() {
    attempt(Deed::kUndo, "", "", [&] { memory_.undo(); });
  }

  void clear() {
    attempt(Deed::kClear, "", "", [&] { memory_.clear(); });
  }

  template <class Call>
  void attempt(Deed deed, const std::string& label, const std::string& new_label,
               const Call& call) {
    Said said;
    said.what = What::kAsked;
    said.client = number_;
    said.deed = deed;
    said.text = label;
    said.new_text = new_label;
    log_.say(said);
    try {
      call();
      said.what = What::kAnswered;
    } catch (const PlaceMemoryError& error) {
      said.what = isFair(error.reason()) ? What::kDeclined : What::kFailed;
      said.text = error.what();
    }
    log_.say(said);
    if (said.what == What::kFailed) _exit(1);
  }

  // As where somebody else cleared the map meanwhile.
  static bool isFair(PlaceMemoryError::Reason reason) {
    using Reason = PlaceMemoryError::Reason;
    return reason == Reason::kUnknownPlace || reason == Reason::kLabelTaken ||
           reason == Reason::kNothingToUndo || reason == Reason::kCannotUndo ||
           reason == Reason::kUnknownLink;
  }

  const std::string& anyOf(const std::vector<std::string>& labels) {
    return labels[random_() % labels.size()];
  }

  PlaceMemory& memory_;
  ChangeLog& log_;
  const unsigned number_;
  const std::string saved_;
  const bool is_alone_;
  std::mt19937 random_;
};

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_BUSY_CLIENT_H
