#ifndef PLACE_MEMORY_TEST_CORE_STORE_SERVED_STORE_H
#define PLACE_MEMORY_TEST_CORE_STORE_SERVED_STORE_H

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/store/scans_fixture.h"
#include "core/store/store_fixture.h"

namespace place_memory::core {

/// All that a store gives to whoever asks.
struct Served {
  std::map<PlaceId, Place> places;
  std::map<std::pair<PlaceId, PlaceId>, PlaceLink> links;
  std::map<PlaceId, EvidenceGrid> grids;
  std::map<PlaceId, CellPlanes> planes;
  std::map<PlaceId, std::vector<SonarReading>> readings;
  std::map<std::int64_t, ScanNode> nodes;  ///< by their stamp
  std::vector<Tie> ties;
  PlaceId next_id = 0;
  std::uint64_t version = 0;
  bool is_named = false;  ///< something is missing, and that is said

  explicit Served(const PlaceStore& store) {
    const PlaceMap map = store.map();
    version = map.version();
    for (const Place& place : map.places()) {
      places[place.id] = place;
      try {
        auto found = store.readings(place.id);
        if (!found.empty()) readings[place.id] = std::move(found);
      } catch (const StoreError&) {
      }
    }
    for (const PlaceLink& link : map.links()) links[{link.first, link.second}] = link;
    store.forEachGrid([&](PlaceId id, const EvidenceGrid& grid) { grids[id] = grid; });
    store.forEachPlanes([&](PlaceId id, const CellPlanes& found) { planes[id] = found; });
    const KeptMap scans = store.scans();
    for (const ScanNode& node : scans.nodes) nodes[node.stamp.count()] = node;
    ties = scans.ties;
    next_id = store.nextId();
    is_named = !store.setAside().empty();
  }
};

inline bool isSame(const Place& one, const Place& other) { return one == other; }
inline bool isSame(const PlaceLink& one, const PlaceLink& other) { return one == other; }
inline bool isSame(const EvidenceGrid& one, const EvidenceGrid& other) { return one == other; }
inline bool isSame(const CellPlanes& one, const CellPlanes& other) {
  return one.occupied == other.occupied && one.empty == other.empty;
}
inline bool isSame(const std::vector<SonarReading>& one, const std::vector<SonarReading>& other) {
  if (one.size() != other.size()) return false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const bool same = one[i].sensor_pose == other[i].sensor_pose &&
                      one[i].range == other[i].range && one[i].spec == other[i].spec;
    if (!same) return false;
  }
  return true;
}
// Which node it came from, and which place it is, may be gone.
inline bool isSame(const ScanNode& one, const ScanNode& other) {
  return one.odom_from_base == other.odom_from_base && one.first_way == other.first_way &&
         one.last_way == other.last_way && one.session == other.session && one.pose == other.pose &&
         one.motion == other.motion && one.motion_way == other.motion_way &&
         one.motion_turn == other.motion_turn && one.compass == other.compass &&
         (one.readings == nullptr) == (other.readings == nullptr) &&
         (one.readings == nullptr || isSame(*one.readings, *other.readings));
}

/// Whether each of a table's rows that is served is one that was written.
template <class Key, class Value>
bool areOf(const Served& served, const std::vector<Served>& wholes,
           std::map<Key, Value> Served::*table) {
  for (const auto& [key, value] : served.*table) {
    bool found = false;
    for (const Served& whole : wholes) {
      const auto at = (whole.*table).find(key);
      found = found || (at != (whole.*table).end() && isSame(value, at->second));
    }
    if (!found) return false;
  }
  return true;
}

inline bool areTiesOf(const Served& served, const std::vector<Served>& wholes) {
  for (const Tie& tie : served.ties) {
    bool found = false;
    for (const Served& whole : wholes) {
      for (const Tie& other : whole.ties) {
        found = found || (tie.relative == other.relative && tie.information == other.information &&
                          tie.closure == other.closure);
      }
    }
    if (!found) return false;
  }
  return true;
}

/// Nothing is served that was not written. `wholes`: every state that the store was in.
inline bool isOf(const Served& served, const std::vector<Served>& wholes) {
  return areOf(served, wholes, &Served::places) && areOf(served, wholes, &Served::links) &&
         areOf(served, wholes, &Served::grids) && areOf(served, wholes, &Served::planes) &&
         areOf(served, wholes, &Served::readings) && areOf(served, wholes, &Served::nodes) &&
         areTiesOf(served, wholes);
}

inline bool isWhole(const Served& served, const Served& whole) {
  return isOf(served, {whole}) && isOf(whole, {served}) && served.version == whole.version &&
         served.next_id >= whole.next_id;
}

constexpr std::size_t kPageSize = 4096;

/// Whether the long form of a test was asked for.
inline bool everyByte() { return std::getenv("PLACE_MEMORY_EVERY_BYTE") != nullptr; }

/// What became of a store that something was done to.
enum class Outcome {
  kRefused,  ///< as a whole, with the reason
  kNamed,    ///< the rest is served, and it is said what is not
  kWhole,    ///< all of it is served
  kMissing,  ///< something is not served, and nothing is said
  kWrong,    ///< something is served that was not written
};

inline const char* inWords(Outcome outcome) {
  switch (outcome) {
    case Outcome::kRefused:
      return "refused";
    case Outcome::kNamed:
      return "named";
    case Outcome::kWhole:
      return "of no effect";
    case Outcome::kMissing:
      return "missing without a word";
    case Outcome::kWrong:
      return "wrong";
  }
  return "";
}

/// A store in which every table has rows.
class ServedStoreTest : public PlaceStoreTest {
 protected:
  void SetUp() override {
    PlaceStore store = open();
    // By the word the pages of places are known.
    PlaceAdded first = addition(1, makePlace("abcdefghij"), makeGrid(1));
    first.readings = makeReadings(1.5);
    commit(store, {first});
    add(store, makePlace("abcdefghij 2"), makeGrid(2), 1);
    add(store, makePlace("c"), makeGrid(3), 2);
    MapChange driven;
    driven.version = 2;
    store.commit(driven, makeScans());
  }

  Served read() const { return Served(open()); }

  // `wholes`: every state that the store was in.
  Outcome outcome(const std::vector<Served>& wholes) const {
    try {
      const Served served = read();
      if (!isOf(served, wholes)) return Outcome::kWrong;
      if (served.is_named) return Outcome::kNamed;
      for (const Served& whole : wholes) {
        if (isWhole(served, whole)) return Outcome::kWhole;
      }
      return Outcome::kMissing;
    } catch (const StoreError&) {
      return Outcome::kRefused;
    }
  }

  // Fails where that is not allowed to happen.
  void count(Outcome found, const std::string& what) {
    ++counts_[inWords(found)];
    EXPECT_TRUE(found != Outcome::kMissing && found != Outcome::kWrong)
        << what << ": " << inWords(found);
  }

  void TearDown() override {
    for (const auto& [what, number] : counts_) {
      RecordProperty(what, number);
      std::printf("%s: %d\n", what.c_str(), number);
    }
  }

  void write(std::size_t offset, const std::string& bytes) const {
    const int file = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset)),
              static_cast<ssize_t>(bytes.size()));
    close(file);
  }

  std::map<std::string, int> counts_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_SERVED_STORE_H
