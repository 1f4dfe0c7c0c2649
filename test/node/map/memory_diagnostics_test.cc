#include "node/map/memory_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

DiagnosticStatusWrapper diagnose(const core::StoreHealth& health, const std::string& problem) {
  DiagnosticStatusWrapper status;
  diagnoseMemory(1, health, "/places.db", problem, status);
  return status;
}

TEST(DiagnoseMemory, SaysHowManyPlacesThereAre) {
  const DiagnosticStatusWrapper status = diagnose({}, "");
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "1 place");
}

TEST(DiagnoseMemory, AStoreThatIsNotUsedIsAnError) {
  const DiagnosticStatusWrapper status = diagnose({}, "it is a diary");
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("in memory only: it is a diary"), std::string::npos);
}

TEST(DiagnoseMemory, AStoreThatFailsLaterIsAnErrorUntilItRecovers) {
  core::StoreHealth health;
  health.ok = false;
  health.problem = "the disk is full";
  const DiagnosticStatusWrapper status = diagnose(health, "");
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("the disk is full"), std::string::npos);
}

TEST(DiagnoseMemory, WhatIsDamagedIsAWarningThatNamesIt) {
  core::StoreHealth health;
  health.set_aside = {"place 3 is damaged", "place 5 is damaged"};
  const DiagnosticStatusWrapper status = diagnose(health, "");
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_NE(status.message.find("place 3 is damaged"), std::string::npos);
  EXPECT_EQ(status.values.front().value, "place 3 is damaged");
  EXPECT_EQ(status.values.at(1).value, "place 5 is damaged");
}

}  // namespace
}  // namespace place_memory::node
