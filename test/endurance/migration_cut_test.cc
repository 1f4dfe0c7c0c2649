#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <thread>

#include "core/store/later_store_fixture.h"
#include "core/store/old_store_fixture.h"
#include "endurance/map_record.h"
#include "endurance/power_cut.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kKills = 8;

/// A store of an older format whose migration is cut off again and again.
class MigrationCutTest : public PlaceStoreTest, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    makeOne();
    old_ = readFile(path_);
    const Clock::time_point begin = Clock::now();
    whole_ = recordOf(open());
    duration_ = Clock::now() - begin;
    ASSERT_EQ(whole_.places.size(), 3U);
  }

  void makeOne() const {
    if (GetParam() < 3) return makeOldStore(path_, GetParam());
    fill();
    GetParam() == 3 ? makeFormat3(path_) : makeFormat4(path_);
  }

  // Opens the old store in a process that ends somehow. Returns how, as waitpid() says.
  int open(const std::function<void()>& begin, const std::function<void(pid_t)>& meanwhile) const {
    for (const auto& entry : fs::directory_iterator(folder_.path())) fs::remove(entry.path());
    writeFile(path_, old_);
    const pid_t child = fork();
    if (child == 0) {
      begin();
      PlaceStoreTest::open();
      _exit(0);
    }
    meanwhile(child);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }
  PlaceStore open() const { return PlaceStoreTest::open(); }

  void expectWhole() const {
    const PlaceStore store = open();
    EXPECT_EQ(difference(whole_, recordOf(store)), "");
    EXPECT_TRUE(store.setAside().empty());
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find(".new-"), std::string::npos) << entry.path();
    }
    EXPECT_EQ(readFile(path_ + ".format-" + std::to_string(GetParam())), old_);
  }

  std::string old_;
  MapRecord whole_;
  Clock::duration duration_{};
};

TEST_P(MigrationCutTest, KilledAnywhereItLeavesTheOldStoreOrTheNewOne) {
  for (int i = 0; i < kKills; ++i) {
    open([] {},
         [&](pid_t child) {
           std::this_thread::sleep_for(duration_ * i / kKills);
           kill(child, SIGKILL);
         });
    expectWhole();
  }
}

TEST_P(MigrationCutTest, WhereverThePowerFailsItLeavesTheOldStoreOrTheNewOne) {
  const int step = std::getenv("PLACE_MEMORY_EVERY_OPERATION") == nullptr ? 17 : 1;
  int cuts = 0;
  for (int operation = 1;; operation += step) {
    const int status =
        open([&] { letPowerFail(operation, static_cast<unsigned>(operation)); }, [](pid_t) {});
    ASSERT_TRUE(WIFEXITED(status)) << status;
    expectWhole();
    if (WEXITSTATUS(status) != kPowerFailed) {
      EXPECT_EQ(WEXITSTATUS(status), 0);
      break;
    }
    ++cuts;
  }
  std::printf("format %d: %d power cuts, %d kills\n", GetParam(), cuts, kKills);
  EXPECT_GT(cuts, 2);
}

INSTANTIATE_TEST_SUITE_P(Formats, MigrationCutTest, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace place_memory::core
