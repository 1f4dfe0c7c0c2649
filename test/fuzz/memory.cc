#include <cmath>
#include <memory>
#include <sstream>
#include <string>

#include "core/map/inverse_change.h"
#include "core/map/place_label.h"
#include "core/memory/map_export.h"
#include "core/random_scan.h"
#include "core/store/packed_edits.h"
#include "fuzz/targets.h"
#include "place_memory/core/place_memory.h"
#include "support/csv.h"

namespace place_memory::fuzz {
namespace {

constexpr std::size_t kMostInverse = std::size_t{1} << 20U;

bool isSound(const core::LinkDirection& direction) {
  // Written so that NaN fails.
  return direction.through >= 0.0 && direction.blocked >= 0.0 && direction.time >= 0.0 &&
         direction.toll >= 0.0 && std::isfinite(direction.through + direction.blocked) &&
         std::isfinite(direction.time + direction.time_sigma + direction.lost_time +
                       direction.toll);
}

void checkMap(const core::MapSnapshot& map) {
  for (const core::Place& place : map.places) {
    require(core::isValidLabel(place.label) && place.map_from_place.isFinite(), "no place");
  }
  for (const core::PlaceLink& link : map.links) {
    require(isSound(link.forward) && isSound(link.backward), "a link that learned nonsense");
  }
  std::istringstream table(core::placesAsCsv(map));
  int line = 0;
  std::size_t rows = 0;
  while (const auto record = support::readRecord(table, line)) ++rows;
  require(rows == map.places.size() + 1, "a table with other rows than places");
  require(core::mapAsGraphml(map).find('\0') == std::string::npos, "no XML");
  core::linksAsCsv(map);
}

void checkPlan(const core::RoutePlan& plan) {
  const core::RouteAnswer& answer = plan.answer;
  if (answer.status != core::RouteAnswer::Status::kFound) {
    return require(!answer.reason.empty() && answer.reason.size() < 1000, "no reason");
  }
  require(answer.best.cost >= 0.0 && !answer.best.places.empty(), "a route of no cost");
  require(answer.best.odds >= 0.0 && answer.best.odds <= 1.0, "no odds");
  require(answer.best.places.size() == plan.best.size(), "a route by other places");
}

/// Asks one thing after the other of a memory of three places in a row.
class Asker {
 public:
  explicit Asker(core::ByteUnpacker& bytes) : bytes_(bytes) {
    core::PlaceMemoryOptions options;
    options.recognizer.threads = 1;
    options.clock = [] { return std::chrono::seconds(2000); };
    memory_ = std::make_unique<core::PlaceMemory>(options);
    for (unsigned i = 1; i <= 3; ++i) learn(i, std::string(1, static_cast<char>('`' + i)));
  }

  void run() {
    for (int deeds = 0; bytes_.left() > 0 && deeds < 64; ++deeds) {
      try {
        act();
      } catch (const core::PlaceMemoryError& error) {
        require(std::string(error.what()).size() > 3, "refused without a reason");
      }
    }
    checkMap(memory_->map());
  }

 private:
  void act() {
    switch (bytes_.take<std::uint8_t>() % 8) {
      case 0:
        return learn(++scans_, bytes_.takeText());
      case 1: {
        const std::string label = bytes_.takeText();
        return memory_->rename(label, bytes_.takeText());
      }
      case 2:
        return memory_->remove(bytes_.takeText());
      case 3:
        return travel();
      case 4: {
        const core::PlaceId from = id();
        const auto order = static_cast<core::LinkOrder>(bytes_.take<std::uint8_t>() % 4);
        const auto toll = bytes_.take<double>();
        return memory_->setLink(from, id(), order, toll, bytes_.take<std::uint8_t>() % 2 == 0);
      }
      case 5:
        memory_->undo(bytes_.take<std::uint8_t>());
        return;
      case 6:
        memory_->history(bytes_.take<std::uint32_t>());
        return;
      default:
        return plan();
    }
  }

  void learn(unsigned seed, const std::string& label) {
    core::Scan scan = core::makeRandomScan(seed % 4);
    scan.id = seed;
    scan.odom_from_scan = {2.0 * seed, 0.0, 0.0};
    scan.begin = std::chrono::seconds(1000 + 10 * seed);
    scan.end = scan.begin + std::chrono::seconds(5);
    scans_ = seed;
    memory_->learn(scan, label, true);
  }

  void travel() {
    core::Traversal traversal;
    traversal.from = id();
    traversal.to = id();
    traversal.begin = std::chrono::nanoseconds(bytes_.take<std::int64_t>());
    traversal.end = std::chrono::nanoseconds(bytes_.take<std::int64_t>());
    traversal.succeeded = bytes_.take<std::uint8_t>() % 2 == 0;
    traversal.source = bytes_.takeText();
    memory_->reportTraversal(traversal);
  }

  void plan() {
    core::RouteQuery query;
    if (bytes_.take<std::uint8_t>() % 2 == 0) query.start = end();
    for (int i = bytes_.take<std::uint8_t>() % 3; i > 0; --i) query.starts.push_back({id(), 0.5});
    query.goal = end();
    for (int i = bytes_.take<std::uint8_t>() % 3; i > 0; --i) {
      const core::PlaceId from = id();
      query.avoided.emplace_back(from, id());
    }
    checkPlan(memory_->plan(query));
  }

  core::RouteEnd end() {
    const auto kind = bytes_.take<std::uint8_t>() % 3;
    if (kind == 0) return {id(), "", std::nullopt};
    if (kind == 1) return {core::kNoPlace, bytes_.takeText(), std::nullopt};
    // Whoever asks sees to it that it is finite.
    core::Pose2d pose{bytes_.take<double>(), bytes_.take<double>(), 0.0};
    if (!pose.isFinite()) pose = {};
    return {core::kNoPlace, "", pose};
  }

  core::PlaceId id() {
    const auto small = bytes_.take<std::int8_t>();
    return small == 127 ? bytes_.take<std::int64_t>() : small;
  }

  core::ByteUnpacker& bytes_;
  std::unique_ptr<core::PlaceMemory> memory_;
  unsigned scans_ = 0;
};

}  // namespace

void runMemory(const std::uint8_t* bytes, std::size_t size) {
  core::ByteUnpacker input(bytes, size);
  Asker(input).run();
}

// What the history keeps of a change is made anew, and taken back.
void runEdits(const std::uint8_t* bytes, std::size_t size) {
  core::ByteUnpacker input(bytes, size);
  core::MapChange change;
  const auto edits = core::unpackEdits(input, core::kDefaultCellSize);
  if (!edits) return;
  core::BytePacker packed;
  core::packEdits(*edits, packed);
  core::ByteUnpacker again(packed.bytes().data(), packed.bytes().size());
  const auto same = core::unpackEdits(again, core::kDefaultCellSize);
  require(same && same->size() == edits->size() && again.left() == 0, "edits of another kind");
  change.edits = *edits;
  core::PlaceMap map;
  change.version = 1;
  const core::PlaceContents contents{
      [](core::PlaceId) { return core::EvidenceGrid(core::GridGeometry{}); },
      [](core::PlaceId) { return std::vector<core::SonarReading>(); }};
  try {
    map.check(change);
  } catch (const std::invalid_argument& error) {
    return require(std::string(error.what()).size() > 3, "refused without a reason");
  }
  const auto inverse = core::inverseOf(change.edits, map, contents, kMostInverse);
  map.apply(change);
  checkMap({map.version(), map.stamp(), map.places(), map.links()});
  if (!inverse) return;
  core::MapChange back;
  back.version = 2;
  back.edits = *inverse;
  map.apply(back);
  require(map.size() == 0, "taken back, and still there");
}

}  // namespace place_memory::fuzz
