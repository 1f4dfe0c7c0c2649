#include "node/answer/kept_scans.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using Problem = ScanChoice::Problem;
using std::chrono::seconds;

constexpr double kMaxAge = 600.0;

std::shared_ptr<const core::Scan> makeScan(std::uint64_t id, seconds end) {
  auto scan = std::make_shared<core::Scan>();
  scan->id = id;
  scan->end = end;
  return scan;
}

void expectRefused(const ScanChoice& choice, Problem problem) {
  EXPECT_EQ(choice.problem, problem);
  EXPECT_EQ(choice.scan, nullptr);
  EXPECT_GT(choice.message.size(), 10U);
}

TEST(KeptScans, WithoutAScanThereIsNone) {
  KeptScans scans(kMaxAge);
  expectRefused(scans.choose(0, seconds(1)), Problem::kNoScan);
  expectRefused(scans.choose(3, seconds(1)), Problem::kNoScan);
  scans.add(makeScan(3, seconds(1)));
  scans.drop();
  expectRefused(scans.choose(3, seconds(1)), Problem::kNoScan);
}

TEST(KeptScans, WhoAsksWhileAScanRunsIsTold) {
  KeptScans scans(kMaxAge);
  scans.setUnderWay(true);
  expectRefused(scans.choose(0, seconds(1)), Problem::kNoScan);
  EXPECT_NE(scans.choose(0, seconds(1)).message.find("one is under way"), std::string::npos);
  scans.add(makeScan(3, seconds(1)));
  EXPECT_NE(scans.choose(0, seconds(1)).message.find("by the scan before"), std::string::npos);
  EXPECT_EQ(scans.choose(3, seconds(1)).message, "") << "it was meant";
  scans.setUnderWay(false);
  EXPECT_EQ(scans.choose(0, seconds(1)).message, "");
}

TEST(KeptScans, ZeroIsTheNewest) {
  KeptScans scans(kMaxAge);
  scans.add(makeScan(3, seconds(1)));
  scans.add(makeScan(4, seconds(2)));
  const ScanChoice choice = scans.choose(0, seconds(2));
  EXPECT_EQ(choice.problem, Problem::kNone);
  ASSERT_NE(choice.scan, nullptr);
  EXPECT_EQ(choice.scan->id, 4U);
}

TEST(KeptScans, OlderOnesAreFoundByTheirId) {
  KeptScans scans(kMaxAge);
  for (std::uint64_t id = 1; id <= KeptScans::kMost + 1; ++id) scans.add(makeScan(id, seconds(1)));
  expectRefused(scans.choose(1, seconds(1)), Problem::kUnknown);
  for (std::uint64_t id = 2; id <= KeptScans::kMost + 1; ++id) {
    const ScanChoice choice = scans.choose(id, seconds(1));
    ASSERT_NE(choice.scan, nullptr) << id;
    EXPECT_EQ(choice.scan->id, id);
  }
  expectRefused(scans.choose(1000, seconds(1)), Problem::kUnknown);
}

TEST(KeptScans, WhatLiesBackTooLongIsRefused) {
  KeptScans scans(kMaxAge);
  scans.add(makeScan(1, seconds(1000)));
  EXPECT_EQ(scans.choose(0, seconds(1600)).problem, Problem::kNone);
  expectRefused(scans.choose(0, seconds(1601)), Problem::kTooOld);
  expectRefused(scans.choose(1, seconds(1601)), Problem::kTooOld);
  EXPECT_EQ(scans.choose(0, seconds(999)).problem, Problem::kNone);
}

}  // namespace
}  // namespace place_memory::node
