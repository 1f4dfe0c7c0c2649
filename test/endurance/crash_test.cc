#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <random>
#include <thread>

#include "core/store/place_store.h"
#include "core/temporary_folder.h"
#include "endurance/busy_memory.h"
#include "endurance/ledger.h"
#include "endurance/power_cut.h"

// Whatever ends a process that changes its map, what it acknowledged is there afterwards, to the
// bit, and the store can be opened. scripts/crash_test runs many more rounds.
namespace place_memory {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 20;
// Some dozen changes; a busy machine needs longer for them.
constexpr std::uintmax_t kLongestLog = 256 << 10;  // [bytes]
constexpr int kLongestPause = 5;                   // after that, or without a log [ms]
// So many a memory needs to be opened, and then some changes.
constexpr int kMostOperations = 600;

int number(const char* name, int by_default) {
  const char* const given = std::getenv(name);
  return given == nullptr ? by_default : std::atoi(given);
}

class CrashTest : public testing::Test {
 protected:
  // Returns how it ended, as waitpid() says.
  int runChild(unsigned clients, const std::function<void()>& begin,
               const std::function<void(pid_t)>& meanwhile) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      begin();
      keepBusy({store_, log_, saved_, clients, static_cast<unsigned>(random_())});
    }
    meanwhile(child);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  static bool hasEnded(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           info.si_pid != 0;
  }

  std::uintmax_t said() const {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(log_, error);
    return error ? 0 : size;
  }

  void killOne(unsigned clients) {
    // Some before they have opened the store.
    const std::uintmax_t enough = random_() % 8 == 0 ? 0 : 1 + random_() % kLongestLog;
    const auto pause = std::chrono::microseconds(random_() % (1000 * kLongestPause));
    const int status = runChild(
        clients, [] {},
        [&](pid_t child) {
          while (said() < enough && !hasEnded(child)) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
          }
          std::this_thread::sleep_for(pause);
          kill(child, SIGKILL);
        });
    follow();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  }

  void cutPowerOfOne(unsigned clients) {
    const int operation = 1 + static_cast<int>(random_() % kMostOperations);
    const auto seed = static_cast<unsigned>(random_());
    const int status = runChild(
        clients, [&] { letPowerFail(operation, seed); }, [](pid_t) {});
    follow();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == kPowerFailed) << status;
  }

  void follow() {
    for (const Said& said : ChangeLog::read(log_)) ledger_.add(said);
    fs::remove(log_);
    for (; said_ < ledger_.problems().size(); ++said_) ADD_FAILURE() << ledger_.problems()[said_];
  }

  void expectAllThatWasTold(const char* what, int rounds) {
    {
      const core::PlaceStore store(store_, core::kDefaultCellSize);
      Said opened;
      opened.what = Said::What::kOpened;
      opened.map = recordOf(store);
      ledger_.add(opened);
      follow();
      EXPECT_TRUE(store.setAside().empty());
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
    expectSoundCopy();
    std::printf(
        "%d %s: %d changes acknowledged, %zu lost or refused, %d opened, %d of them with a "
        "change that was kept and not told\n",
        rounds, what, ledger_.acknowledged(), ledger_.problems().size(), ledger_.openings(),
        ledger_.untold());
    EXPECT_GT(ledger_.openings(), rounds / 4);
    EXPECT_GT(ledger_.acknowledged(), rounds);
  }

  void expectSoundCopy() const {
    ASSERT_TRUE(fs::exists(saved_));
    const core::PlaceStore copy(saved_, core::kDefaultCellSize);
    EXPECT_TRUE(copy.setAside().empty());
    EXPECT_EQ(recordOf(copy).grids.size(), copy.map().size());
  }

  const TemporaryFolder folder_;
  const TemporaryFolder copies_;
  const std::string saved_ = copies_.file("saved.db");
  const std::string store_ = folder_.file("places.db");
  const std::string log_ = folder_.file("log");
  std::mt19937 random_{static_cast<unsigned>(number("PLACE_MEMORY_SEED", 1))};
  Ledger ledger_;
  std::size_t said_ = 0;
};

TEST_F(CrashTest, NothingIsLostWhereTheProcessIsKilled) {
  const int rounds = number("PLACE_MEMORY_KILLS", kRounds);
  for (int round = 0; round < rounds; ++round) killOne(round % 2 == 0 ? 1 : 4);
  expectAllThatWasTold("kills", rounds);
}

TEST_F(CrashTest, NothingIsLostWhereThePowerFails) {
  const int rounds = number("PLACE_MEMORY_POWER_CUTS", kRounds);
  for (int round = 0; round < rounds; ++round) cutPowerOfOne(round % 2 == 0 ? 1 : 4);
  expectAllThatWasTold("power cuts", rounds);
}

}  // namespace
}  // namespace place_memory
