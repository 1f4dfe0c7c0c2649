#include <gtest/gtest.h>
#include <sqlite3.h>

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

// What those hear who listen to the map.
namespace place_memory::core {
namespace {

/// A map and its grids, made of nothing but the changes.
class Mirror {
 public:
  void hear(const MapChange& change) {
    map_.apply(change);
    for (const MapEdit& edit : change.edits) {
      if (const auto* added = std::get_if<PlaceAdded>(&edit))
        grids_[added->place.id] = *added->grid;
      if (const auto* adapted = std::get_if<GridAdapted>(&edit))
        grids_[adapted->id] = *adapted->grid;
    }
  }

  void expectSame(const PlaceMemory& memory) const {
    const MapSnapshot snapshot = memory.map();
    EXPECT_EQ(map_.version(), snapshot.version);
    EXPECT_EQ(map_.stamp(), snapshot.stamp);
    EXPECT_TRUE(map_.places() == snapshot.places);
    EXPECT_TRUE(map_.links() == snapshot.links);
    for (const Place& place : snapshot.places)
      EXPECT_EQ(memory.grid(place.id), grids_.at(place.id));
  }

 private:
  PlaceMap map_;
  std::map<PlaceId, EvidenceGrid> grids_;
};

class MapListenerTest : public testing::Test {
 protected:
  PlaceMemoryOptions options() const {
    PlaceMemoryOptions options;
    options.store_path = folder_.file("places.db");
    options.recognizer.calibration.right = {-20.0, 0.0, 0.0, 0.0, 30.0};
    options.recognizer.calibration.known = {-20.0};
    options.adaptation.enabled = true;
    options.clock = [this] { return std::chrono::nanoseconds(++now_); };
    return options;
  }

  const TemporaryFolder folder_;
  mutable std::atomic<std::int64_t> now_{100};
};

TEST_F(MapListenerTest, HearsOfEveryChangeOnceItIsKept) {
  PlaceMemory memory(options());
  std::vector<std::uint64_t> versions;
  memory.listen([&](const MapChange& change) {
    versions.push_back(change.version);
    EXPECT_EQ(memory.version(), change.version);
    EXPECT_GT(change.stamp.count(), 100);
  });
  memory.learn(makeRandomScan(1), "a");
  memory.rename("a", "b");
  memory.remove("b");
  EXPECT_THROW(memory.remove("b"), PlaceMemoryError);
  memory.clear();
  EXPECT_EQ(versions, (std::vector<std::uint64_t>{1, 2, 3, 4}));
}

TEST_F(MapListenerTest, VersionAndStampSurviveARestart) {
  MapSnapshot before;
  {
    PlaceMemory memory(options());
    memory.learn(makeRandomScan(1), "a");
    before = memory.map();
    EXPECT_EQ(before.version, 1U);
  }
  const MapSnapshot after = PlaceMemory(options()).map();
  EXPECT_EQ(after.version, before.version);
  EXPECT_EQ(after.stamp, before.stamp);
  EXPECT_TRUE(after.places == before.places);
}

TEST_F(MapListenerTest, WhatAListenerDoesWrongHarmsNobody) {
  PlaceMemory memory(options());
  bool refused = false;
  memory.listen([&](const MapChange&) {
    try {
      memory.clear();
    } catch (const std::logic_error&) {
      refused = true;
    }
    throw std::runtime_error("not to be heard of again");
  });
  int heard = 0;
  memory.listen([&](const MapChange&) { ++heard; });
  memory.learn(makeRandomScan(1), "a");
  EXPECT_TRUE(refused);
  EXPECT_EQ(heard, 1);
  EXPECT_EQ(memory.size(), 1U);
}

// The listener stands for a disk that takes its time.
TEST_F(MapListenerTest, ReadersDoNotWaitForAChange) {
  PlaceMemory memory(options());
  memory.learn(makeRandomScan(1), "a");
  std::mutex mutex;
  std::condition_variable changed;
  bool is_held = false;
  bool goes_on = false;
  memory.listen([&](const MapChange&) {
    std::unique_lock<std::mutex> lock(mutex);
    is_held = true;
    changed.notify_all();
    changed.wait(lock, [&] { return goes_on; });
  });
  std::thread learner([&] { memory.learn(makeRandomScan(2), "b"); });
  {
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [&] { return is_held; });
  }
  EXPECT_EQ(memory.map().places.size(), 2U);
  EXPECT_EQ(memory.whereabouts().current_label, "b");
  EXPECT_EQ(memory.recognize(makeRandomScan(50), kHeadingWindow).labels.size(), 2U);
  memory.forgetWhereabouts();
  {
    const std::lock_guard<std::mutex> lock(mutex);
    goes_on = true;
  }
  changed.notify_all();
  learner.join();
}

TEST_F(MapListenerTest, TheStoresHealthIsSeenTheMomentItChanges) {
  { PlaceMemory(options()).learn(makeRandomScan(1), "a"); }
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(options().store_path.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database,
                         "CREATE TRIGGER full AFTER INSERT ON place WHEN new.label = 'b' BEGIN "
                         "SELECT RAISE(ABORT, 'full'); END",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  PlaceMemory memory(options());
  std::vector<StoreHealth> seen;
  memory.watchStore([&seen](const StoreHealth& health) { seen.push_back(health); });
  EXPECT_TRUE(memory.storeHealth().ok);
  EXPECT_THROW(memory.learn(makeRandomScan(2), "b"), PlaceMemoryError);
  EXPECT_FALSE(memory.storeHealth().ok);
  EXPECT_NE(memory.storeHealth().problem, "");
  EXPECT_EQ(memory.size(), 1U);
  EXPECT_EQ(memory.version(), 1U);
  EXPECT_EQ(memory.whereabouts().previous, kNoPlace);
  memory.learn(makeRandomScan(3), "c");
  EXPECT_TRUE(memory.storeHealth().ok);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_FALSE(seen[0].ok);
  EXPECT_TRUE(seen[1].ok);
  EXPECT_GT(seen[1].since, seen[0].since);
}

/// Works on a memory from many sides, as clients do.
class Crowd {
 public:
  explicit Crowd(PlaceMemory& memory) : memory_(memory) {}

  void run() {
    std::vector<std::thread> threads;
    for (unsigned who = 0; who < 2; ++who) threads.emplace_back([this, who] { learn(who); });
    for (int who = 0; who < 2; ++who) threads.emplace_back([this] { recognize(); });
    threads.emplace_back([this] { rename(); });
    threads.emplace_back([this] { remove(); });
    threads.emplace_back([this] { look(); });
    for (std::thread& thread : threads) thread.join();
  }

  int learned() const { return learned_; }
  int recognized() const { return recognized_; }

 private:
  static constexpr int kRounds = 40;

  void learn(unsigned who) {
    for (unsigned i = 0; i < kRounds; ++i) {
      Scan scan = makeRandomScan(2 + 2 * i + who);
      scan.id = 2 + 2 * i + who;
      memory_.learn(scan, "");
      ++learned_;
    }
  }

  void recognize() {
    for (int i = 0; i < kRounds; ++i) {
      Scan scan = makeRandomScan(1);
      scan.end += std::chrono::seconds(++seconds_);
      const PlaceMemory::Answer answer = memory_.recognize(scan, kHeadingWindow);
      EXPECT_EQ(answer.labels.size(), answer.recognition.matches.size());
      if (answer.labels.front() == "stays") ++recognized_;
    }
  }

  // A place may be gone before it can be renamed or removed.
  void rename() {
    for (int i = 0; i < kRounds; ++i) {
      try {
        memory_.rename("place " + std::to_string(2 + i), "renamed " + std::to_string(i));
      } catch (const PlaceMemoryError& error) {
        EXPECT_EQ(error.reason(), PlaceMemoryError::Reason::kUnknownPlace);
      }
    }
  }

  void remove() {
    for (int i = 0; i < kRounds; ++i) {
      const std::vector<Place> places = memory_.map().places;
      if (places.back().label == "stays") continue;
      try {
        memory_.remove(places.back().label);
      } catch (const PlaceMemoryError& error) {
        EXPECT_EQ(error.reason(), PlaceMemoryError::Reason::kUnknownPlace);
      }
    }
  }

  void look() {
    for (int i = 0; i < kRounds; ++i) {
      const MapSnapshot map = memory_.map();
      EXPECT_GE(map.places.size(), 1U);
      EXPECT_NO_THROW(PlaceMap(map.places, map.links, map.version, map.stamp));
      const Whereabouts whereabouts = memory_.whereabouts();
      EXPECT_EQ(whereabouts.current == kNoPlace, whereabouts.current_label.empty());
      if (i % 10 == 9) memory_.forgetWhereabouts();
    }
  }

  PlaceMemory& memory_;
  std::atomic<int> learned_{0};
  std::atomic<int> recognized_{0};
  std::atomic<int> seconds_{0};
};

TEST_F(MapListenerTest, AMapMadeOfTheChangesIsTheMapWhateverGoesOn) {
  Mirror mirror;
  {
    PlaceMemory memory(options());
    memory.listen([&mirror](const MapChange& change) { mirror.hear(change); });
    memory.learn(makeRandomScan(1), "stays");
    Crowd crowd(memory);
    crowd.run();
    EXPECT_EQ(crowd.learned(), 80);
    EXPECT_EQ(crowd.recognized(), 80);
    mirror.expectSame(memory);
  }
  mirror.expectSame(PlaceMemory(options()));
}

}  // namespace
}  // namespace place_memory::core
