#include "tools/drive_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

using std::chrono::nanoseconds;

const nanoseconds kStamp(1612345678901499999);

TEST(DriveTables, GiveTimeToTheMillisecond) {
  EXPECT_EQ(inSeconds(kStamp), "1612345678.901");
  EXPECT_EQ(inSeconds(nanoseconds(1999600000)), "2.000");
}

TEST(DriveTables, LeaveFieldsEmptyOfWhatIsNotKnown) {
  EXPECT_EQ(trajectoryRow(kStamp, core::Pose2d{1.0, -2.5, 4.0}, 0.25),
            "1612345678.901,1.0000,-2.5000,-2.28319,0.2500");
  EXPECT_EQ(trajectoryRow(kStamp, std::nullopt, 1.0), "1612345678.901,,,,1.0000");
  core::ScanDecision decision;
  decision.stamp = kStamp;
  decision.kind = core::ScanDecision::Kind::kBetween;
  EXPECT_EQ(answerRow(decision), "1612345678.901,between,,,,,0.0000,0.0000,");
}

TEST(DriveTables, NameThePlace) {
  core::ScanDecision decision;
  decision.stamp = kStamp;
  decision.kind = core::ScanDecision::Kind::kTracked;
  decision.place = 7;
  decision.place_from_base = {0.5, 0.25, -1.0};
  decision.belief = 0.9;
  decision.lost = 0.01;
  decision.reason = "it fits, and well";
  EXPECT_EQ(answerRow(decision),
            "1612345678.901,tracked,7,0.5000,0.2500,-1.00000,0.9000,0.0100,\"it fits, and well\"");
  const core::MappedPlace place{7, "place_7", kStamp, {1.0, 2.0, 3.0}, false};
  EXPECT_EQ(mapRow(place, "hall, west"), "7,\"hall, west\",1612345678.901,1.0000,2.0000,3.00000");
}

TEST(DriveTables, EveryRowHasTheColumnsOfItsHeader) {
  const auto columns = [](const std::string& row) {
    return std::count(row.begin(), row.end(), ',');
  };
  EXPECT_EQ(columns(trajectoryRow(kStamp, std::nullopt, 1.0)), columns(kTrajectoryHeader));
  EXPECT_EQ(columns(trajectoryRow(kStamp, core::Pose2d(), 1.0)), columns(kTrajectoryHeader));
  EXPECT_EQ(columns(finalRow(kStamp, {})), columns(kFinalHeader));
  EXPECT_EQ(columns(mapRow({}, "a")), columns(kMapHeader));
  EXPECT_EQ(columns(answerRow({})), columns(kAnswersHeader));
}

TEST(DriveTable, IsWrittenOnlyWhereItHasAPath) {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.csv");
  DriveTable none("", "t");
  none.add("1");
  none.close();
  DriveTable table(path, "t");
  table.add("1");
  table.close();
  std::ifstream file(path);
  std::string header, row, more;
  EXPECT_TRUE(file >> header >> row);
  EXPECT_FALSE(file >> more);
  EXPECT_EQ(header, "t");
  EXPECT_EQ(row, "1");
}

TEST(DriveTable, SaysWhereItCannotBeWritten) {
  EXPECT_THROW(DriveTable("/nowhere/t.csv", "t"), std::runtime_error);
  EXPECT_THROW(DriveTable("/dev/full", "t"), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::tools
