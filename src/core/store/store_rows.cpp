#include "core/store/store_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/map/place_label.h"
#include "core/store/packed_bytes.h"
#include "core/store/packed_readings.h"
#include "core/store/row_checksum.h"

namespace place_memory::core {
namespace {

std::uint64_t checksumOf(const Place& place) {
  return RowChecksum()
      .add(place.id)
      .add(place.identity.data(), place.identity.size())
      .add(place.label)
      .add(place.map_from_place)
      .add(place.session)
      .add(place.place_from_robot)
      .add(std::int64_t{place.learned.count()})
      .value();
}

RowChecksum& add(RowChecksum& checksum, const LinkDirection& direction) {
  return checksum.add(std::uint64_t{direction.succeeded})
      .add(std::uint64_t{direction.failed})
      .add(std::int64_t{direction.last.count()});
}

std::vector<unsigned char> packHabit(const LinkDirection& direction) {
  BytePacker bytes;
  bytes.add(direction.through).add(direction.blocked).add(direction.time);
  bytes.add(direction.time_sigma).add(direction.lost_time).add(direction.toll);
  bytes.add(static_cast<std::uint8_t>(direction.forbidden));
  return bytes.bytes();
}

bool unpackHabit(const SqliteStatement& row, int column, LinkDirection& direction) {
  if (row.size(column) == 0) {  // of format 4, which knew the bare counts
    direction.through = direction.succeeded;
    direction.blocked = direction.failed;
    return true;
  }
  ByteUnpacker bytes(row.blob(column), row.size(column));
  bool sound = true;
  for (double* number : {&direction.through, &direction.blocked, &direction.time,
                         &direction.time_sigma, &direction.lost_time, &direction.toll}) {
    *number = bytes.take<double>();
    sound = sound && *number >= 0.0 && std::isfinite(*number);
  }
  direction.forbidden = bytes.take<std::uint8_t>() != 0;
  return sound && bytes.good() && bytes.left() == 0;
}

// With habits from the columns where they stand, so that rows of format 4 keep their checksums.
std::uint64_t checksumOf(const LinkRow& row, const std::vector<unsigned char>& forward,
                         const std::vector<unsigned char>& backward) {
  RowChecksum checksum;
  checksum.add(row.id).add(row.link.first).add(row.link.second).add(row.link.first_from_second);
  for (const double element : row.link.covariance) checksum.add(element);
  add(checksum, row.link.forward);
  add(checksum, row.link.backward);
  if (!forward.empty()) checksum.add(forward.data(), forward.size());
  if (!backward.empty()) checksum.add(backward.data(), backward.size());
  return checksum.value();
}

std::uint64_t checksumOf(PlaceId place, const void* bytes, std::size_t size) {
  return RowChecksum().add(place).add(bytes, size).value();
}

std::vector<unsigned char> bytesAt(const SqliteStatement& row, int column) {
  const auto* bytes = static_cast<const unsigned char*>(row.blob(column));
  return {bytes, bytes + row.size(column)};
}

std::uint64_t checksumOf(std::int64_t id, const Traversal& traversal) {
  return RowChecksum()
      .add(id)
      .add(traversal.from)
      .add(traversal.to)
      .add(std::int64_t{traversal.begin.count()})
      .add(std::int64_t{traversal.end.count()})
      .add(std::int64_t{traversal.succeeded ? 1 : 0})
      .add(traversal.source)
      .value();
}

bool isId(PlaceId id) { return id > kNoPlace && id < kPlaceIdLimit; }

bool isSound(const Place& place) {
  return isId(place.id) && isValidLabel(place.label) && place.map_from_place.isFinite() &&
         place.place_from_robot.isFinite() && place.session > kNoSession;
}

bool isSound(const PlaceLink& link) {
  return isId(link.first) && isId(link.second) && link.first < link.second &&
         link.first_from_second.isFinite() &&
         std::all_of(link.covariance.begin(), link.covariance.end(),
                     [](double element) { return std::isfinite(element); });
}

Pose2d poseAt(const SqliteStatement& row, int column) {
  return {row.real(column), row.real(column + 1), row.real(column + 2)};
}

void bindPose(SqliteStatement& statement, const Pose2d& pose) {
  statement.bind(pose.x).bind(pose.y).bind(pose.yaw);
}

LinkDirection directionAt(const SqliteStatement& row, int column) {
  LinkDirection direction;
  direction.succeeded = static_cast<std::uint32_t>(row.integer(column));
  direction.failed = static_cast<std::uint32_t>(row.integer(column + 1));
  direction.last = std::chrono::nanoseconds(row.integer(column + 2));
  return direction;
}

void bindDirection(SqliteStatement& statement, const LinkDirection& direction) {
  statement.bind(std::int64_t{direction.succeeded})
      .bind(std::int64_t{direction.failed})
      .bind(std::int64_t{direction.last.count()});
}

bool checksumIs(const SqliteStatement& row, int column, std::uint64_t checksum) {
  return static_cast<std::uint64_t>(row.integer(column)) == checksum;
}

std::uint64_t finish(SqliteStatement& insert, std::uint64_t checksum) {
  insert.bind(static_cast<std::int64_t>(checksum)).run();
  return checksum;
}

}  // namespace

std::uint64_t writePlace(SqliteStatement& insert, const Place& place) {
  insert.bind(place.id).bind(place.identity.data(), place.identity.size()).bind(place.label);
  bindPose(insert, place.map_from_place);
  insert.bind(place.session);
  bindPose(insert, place.place_from_robot);
  insert.bind(std::int64_t{place.learned.count()});
  return finish(insert, checksumOf(place));
}

std::optional<Place> readPlace(const SqliteStatement& row) {
  Place place;
  if (row.size(1) != place.identity.size()) return std::nullopt;
  place.id = row.integer(0);
  std::memcpy(place.identity.data(), row.blob(1), place.identity.size());
  place.label = row.text(2);
  place.map_from_place = poseAt(row, 3);
  place.session = row.integer(6);
  place.place_from_robot = poseAt(row, 7);
  place.learned = std::chrono::nanoseconds(row.integer(10));
  if (!checksumIs(row, 11, checksumOf(place)) || !isSound(place)) return std::nullopt;
  return place;
}

std::uint64_t writeLink(SqliteStatement& insert, const LinkRow& row) {
  BytePacker covariance;
  for (const double element : row.link.covariance) covariance.add(element);
  insert.bind(row.id).bind(row.link.first).bind(row.link.second);
  bindPose(insert, row.link.first_from_second);
  insert.bind(covariance.bytes().data(), covariance.bytes().size());
  bindDirection(insert, row.link.forward);
  bindDirection(insert, row.link.backward);
  const std::vector<unsigned char> forward = packHabit(row.link.forward);
  const std::vector<unsigned char> backward = packHabit(row.link.backward);
  insert.bind(forward.data(), forward.size()).bind(backward.data(), backward.size());
  return finish(insert, checksumOf(row, forward, backward));
}

std::optional<LinkRow> readLink(const SqliteStatement& row) {
  LinkRow result;
  result.id = row.integer(0);
  PlaceLink& link = result.link;
  link.first = row.integer(1);
  link.second = row.integer(2);
  link.first_from_second = poseAt(row, 3);
  ByteUnpacker covariance(row.blob(6), row.size(6));
  for (double& element : link.covariance) element = covariance.take<double>();
  link.forward = directionAt(row, 7);
  link.backward = directionAt(row, 10);
  const bool sound = covariance.good() && covariance.left() == 0 &&
                     checksumIs(row, kLinkChecksumColumn,
                                checksumOf(result, bytesAt(row, 13), bytesAt(row, 14))) &&
                     unpackHabit(row, 13, link.forward) && unpackHabit(row, 14, link.backward) &&
                     isSound(link) && result.id >> kLinkShift == link.first;
  return sound ? std::optional<LinkRow>(result) : std::nullopt;
}

std::uint64_t writeGrid(SqliteStatement& insert, PlaceId place, const EvidenceGrid& grid) {
  const auto& cells = grid.cells();
  insert.bind(place).bind(cells.data(), cells.size());
  return finish(insert, checksumOf(place, cells.data(), cells.size()));
}

std::optional<EvidenceGrid> readGrid(const SqliteStatement& row, double cell_size) {
  const void* cells = row.blob(1);
  if (row.size(1) != kGridCells ||
      !checksumIs(row, 2, checksumOf(row.integer(0), cells, kGridCells))) {
    return std::nullopt;
  }
  EvidenceGrid grid(GridGeometry{cell_size});
  std::memcpy(grid.cells().data(), cells, kGridCells);
  return grid;
}

std::uint64_t writeReadings(SqliteStatement& insert, PlaceId place,
                            const std::vector<SonarReading>& readings) {
  const std::vector<unsigned char> bytes = packReadings(readings);
  insert.bind(place).bind(bytes.data(), bytes.size());
  return finish(insert, checksumOf(place, bytes.data(), bytes.size()));
}

std::optional<std::vector<SonarReading>> readReadings(const SqliteStatement& row) {
  const void* bytes = row.blob(1);
  if (!checksumIs(row, 2, checksumOf(row.integer(0), bytes, row.size(1)))) return std::nullopt;
  return unpackReadings(bytes, row.size(1));
}

std::uint64_t writeTraversal(SqliteStatement& insert, std::int64_t id, const Traversal& traversal) {
  insert.bind(id).bind(traversal.from).bind(traversal.to);
  insert.bind(std::int64_t{traversal.begin.count()}).bind(std::int64_t{traversal.end.count()});
  insert.bind(std::int64_t{traversal.succeeded ? 1 : 0}).bind(traversal.source);
  return finish(insert, checksumOf(id, traversal));
}

std::optional<Traversal> readTraversal(const SqliteStatement& row) {
  Traversal traversal;
  traversal.from = row.integer(1);
  traversal.to = row.integer(2);
  traversal.begin = std::chrono::nanoseconds(row.integer(3));
  traversal.end = std::chrono::nanoseconds(row.integer(4));
  traversal.succeeded = row.integer(5) == 1;
  traversal.source = row.text(6);
  if (!checksumIs(row, 7, checksumOf(row.integer(0), traversal))) return std::nullopt;
  return traversal;
}

}  // namespace place_memory::core
