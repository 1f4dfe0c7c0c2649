#ifndef PLACE_MEMORY_TOOLS_DRIVE_TABLES_H
#define PLACE_MEMORY_TOOLS_DRIVE_TABLES_H

#include <chrono>
#include <fstream>
#include <optional>
#include <string>

#include "core/mapping/mapper.h"

namespace place_memory::tools {

/// A table that is written, or not where it has no path.
class DriveTable {
 public:
  /// Writes the header. Throws std::runtime_error where it cannot be written.
  DriveTable(std::string path, const std::string& header);

  void add(const std::string& row);
  /// Throws std::runtime_error where not all of it could be written.
  void close();

 private:
  void check() const;

  std::string path_;
  std::ofstream file_;
};

constexpr char kTrajectoryHeader[] = "t,x,y,yaw,lost";
constexpr char kFinalHeader[] = "t,x,y,yaw";
constexpr char kMapHeader[] = "id,label,t,x,y,yaw";
constexpr char kAnswersHeader[] = "t,decision,place,dx,dy,dyaw,belief,lost,reason";

/// [s], to the millisecond.
std::string inSeconds(std::chrono::nanoseconds stamp);

std::string trajectoryRow(std::chrono::nanoseconds stamp,
                          const std::optional<core::Pose2d>& map_from_base, double lost);
std::string finalRow(std::chrono::nanoseconds stamp, const core::Pose2d& map_from_base);
/// `label`: as the store has it.
std::string mapRow(const core::MappedPlace& place, const std::string& label);
std::string answerRow(const core::ScanDecision& decision);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_DRIVE_TABLES_H
