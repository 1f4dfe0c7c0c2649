#include "core/store/store_scans.h"

#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/store/packed_bytes.h"
#include "core/store/packed_readings.h"
#include "core/store/row_checksum.h"
#include "core/store/store_writer.h"
#include "core/store/table_scan.h"

namespace place_memory::core {
namespace {

constexpr std::int64_t kNoNode = -1;
constexpr TableScan kNodes{
    "node", "id", "id, session, x, y, yaw, stamp_ns, place_id, before, way, readings, checksum"};
constexpr TableScan kTies{"tie", "id",
                          "id, place_node, node, x, y, yaw, information, closure, checksum"};
constexpr TableScan kWheels{"wheels", "id", "id, bend, turn_factor, checksum"};

using Bytes = std::vector<unsigned char>;

std::int64_t beforeOf(const ScanNode& node) {
  return node.before ? static_cast<std::int64_t>(*node.before) : kNoNode;
}

Bytes wayOf(const ScanNode& node) {
  BytePacker bytes;
  for (const Pose2d& pose : {node.odom_from_base, node.motion}) {
    bytes.add(pose.x).add(pose.y).add(pose.yaw);
  }
  bytes.add(node.first_way).add(node.last_way).add(node.motion_way).add(node.motion_turn);
  bytes.add(node.compass ? *node.compass : std::nan(""));
  return bytes.bytes();
}

bool unpackWay(const SqliteStatement& row, int column, ScanNode& node) {
  ByteUnpacker bytes(row.blob(column), row.size(column));
  for (Pose2d* pose : {&node.odom_from_base, &node.motion}) {
    for (double* number : {&pose->x, &pose->y, &pose->yaw}) *number = bytes.take<double>();
  }
  for (double* number : {&node.first_way, &node.last_way, &node.motion_way, &node.motion_turn}) {
    *number = bytes.take<double>();
    if (!std::isfinite(*number)) return false;
  }
  const auto compass = bytes.take<double>();
  if (!std::isnan(compass)) node.compass = compass;
  return bytes.good() && bytes.left() == 0 && node.odom_from_base.isFinite() &&
         node.motion.isFinite();
}

std::uint64_t checksumOf(std::int64_t id, const ScanNode& node, const Bytes& way,
                         const void* readings, std::size_t size) {
  return RowChecksum()
      .add(id)
      .add(std::int64_t{node.session})
      .add(node.pose)
      .add(std::int64_t{node.stamp.count()})
      .add(node.place)
      .add(beforeOf(node))
      .add(way.data(), way.size())
      .add(readings, size)
      .value();
}

Bytes informationOf(const Tie& tie) {
  BytePacker bytes;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) bytes.add(double{tie.information(row, column)});
  }
  return bytes.bytes();
}

std::uint64_t checksumOf(std::int64_t id, const Tie& tie) {
  const Bytes information = informationOf(tie);
  return RowChecksum()
      .add(id)
      .add(static_cast<std::int64_t>(tie.place))
      .add(static_cast<std::int64_t>(tie.node))
      .add(tie.relative)
      .add(information.data(), information.size())
      .add(std::int64_t{tie.closure})
      .value();
}

std::uint64_t checksumOf(const OdometryErrors& errors) {
  return RowChecksum().add(std::int64_t{1}).add(errors.bend).add(errors.turn_factor).value();
}

Pose2d poseAt(const SqliteStatement& row, int column) {
  return {row.real(column), row.real(column + 1), row.real(column + 2)};
}

std::optional<ScanNode> readNode(const SqliteStatement& row) {
  ScanNode node;
  node.session = static_cast<int>(row.integer(1));
  node.pose = poseAt(row, 2);
  node.stamp = std::chrono::nanoseconds(row.integer(5));
  node.place = row.integer(6);
  if (row.integer(7) != kNoNode) node.before = static_cast<NodeIndex>(row.integer(7));
  if (!unpackWay(row, 8, node) || !node.pose.isFinite()) return std::nullopt;
  const auto checksum = checksumOf(row.integer(0), node, wayOf(node), row.blob(9), row.size(9));
  if (checksum != static_cast<std::uint64_t>(row.integer(10))) return std::nullopt;
  if (row.size(9) == 0) return node;  // its readings were not kept
  auto readings = unpackReadings(row.blob(9), row.size(9));
  if (!readings) return std::nullopt;
  node.readings = std::make_shared<const std::vector<SonarReading>>(std::move(*readings));
  return node;
}

std::optional<Tie> readTie(const SqliteStatement& row) {
  Tie tie;
  tie.place = static_cast<NodeIndex>(row.integer(1));
  tie.node = static_cast<NodeIndex>(row.integer(2));
  tie.relative = poseAt(row, 3);
  ByteUnpacker bytes(row.blob(6), row.size(6));
  for (int i = 0; i < 9; ++i) tie.information(i / 3, i % 3) = bytes.take<double>();
  tie.closure = static_cast<int>(row.integer(7));
  const bool sound = bytes.good() && bytes.left() == 0 && tie.relative.isFinite() &&
                     tie.information.allFinite() &&
                     checksumOf(row.integer(0), tie) == static_cast<std::uint64_t>(row.integer(8));
  return sound ? std::optional<Tie>(tie) : std::nullopt;
}

/// Reads the rows of one table, counts them and says what is damaged.
class CountedScan {
 public:
  CountedScan(SqliteDatabase& database, const StoreHead* head, Damages& damages)
      : database_(database), head_(head), damages_(damages) {}

  /// `read` is false of a row that is not as it was written; `rows` is what they are called.
  template <typename Read>
  TableTotal operator()(StoreTable table, const TableScan& scan, int checksum,
                        const std::string& rows, const Read& read) {
    TableFindings found;
    scanTable(
        database_, scan,
        [&](const SqliteStatement& row) {
          found.all.add(static_cast<std::uint64_t>(row.integer(checksum)));
          if (!read(row)) ++found.bad;
        },
        [&](std::int64_t /*unreadable*/) {
          found.all.add(0);
          ++found.bad;
        });
    if (found.bad > 0) {
      damages_.add(std::to_string(found.bad) + " " + rows + " are damaged and were left out");
    }
    if (head_ != nullptr) damages_.add(compareTotals(head_->totals.of(table), found, rows));
    return found.all;
  }

 private:
  SqliteDatabase& database_;
  const StoreHead* head_;
  Damages& damages_;
};

void removeFrom(SqliteDatabase& database, const std::string& table, std::int64_t first,
                CountedTable& rows) {
  std::vector<std::int64_t> ids;
  {
    SqliteStatement query(database, "SELECT id FROM " + table + " WHERE id >= ?");
    query.bind(first);
    while (query.step()) ids.push_back(query.integer(0));
  }
  for (const std::int64_t id : ids) rows.remove(id);
}

void writeNodes(SqliteDatabase& database, const std::vector<ScanNode>& nodes, TableTotal& total) {
  CountedTable rows(database, "node", "id", 11, total);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ScanNode& node = nodes[i];
    const auto id = static_cast<std::int64_t>(i);
    const Bytes way = wayOf(node);
    const Bytes readings = node.readings ? packReadings(*node.readings) : Bytes();
    const std::uint64_t checksum = checksumOf(id, node, way, readings.data(), readings.size());
    if (rows.holds(id, checksum)) continue;
    SqliteStatement& row = rows.replace(id);
    row.bind(id).bind(std::int64_t{node.session});
    row.bind(node.pose.x).bind(node.pose.y).bind(node.pose.yaw);
    row.bind(std::int64_t{node.stamp.count()}).bind(node.place).bind(beforeOf(node));
    row.bind(way.data(), way.size()).bind(readings.data(), readings.size());
    row.bind(static_cast<std::int64_t>(checksum)).run();
    rows.add(checksum);
  }
  removeFrom(database, "node", static_cast<std::int64_t>(nodes.size()), rows);
}

void writeTies(SqliteDatabase& database, const std::vector<Tie>& ties, TableTotal& total) {
  CountedTable rows(database, "tie", "id", 9, total);
  for (std::size_t i = 0; i < ties.size(); ++i) {
    const Tie& tie = ties[i];
    const auto id = static_cast<std::int64_t>(i);
    const std::uint64_t checksum = checksumOf(id, tie);
    if (rows.holds(id, checksum)) continue;
    const Bytes information = informationOf(tie);
    SqliteStatement& row = rows.replace(id);
    row.bind(id).bind(static_cast<std::int64_t>(tie.place));
    row.bind(static_cast<std::int64_t>(tie.node));
    row.bind(tie.relative.x).bind(tie.relative.y).bind(tie.relative.yaw);
    row.bind(information.data(), information.size()).bind(std::int64_t{tie.closure});
    row.bind(static_cast<std::int64_t>(checksum)).run();
    rows.add(checksum);
  }
  removeFrom(database, "tie", static_cast<std::int64_t>(ties.size()), rows);
}

}  // namespace

KeptMap readScans(SqliteDatabase& database, const StoreHead* head, Damages& damages,
                  StoreTotals& found) {
  KeptMap scans;
  CountedScan scan(database, head, damages);
  std::unordered_map<NodeIndex, NodeIndex> now;  // by the number in the store
  found.of(StoreTable::kNode) =
      scan(StoreTable::kNode, kNodes, 10, "scans of drives", [&](const SqliteStatement& row) {
        std::optional<ScanNode> node = readNode(row);
        if (!node) return false;
        if (node->before) {
          const auto before = now.find(*node->before);
          node->before = before == now.end() ? std::nullopt : std::make_optional(before->second);
        }
        now[static_cast<NodeIndex>(row.integer(0))] = scans.nodes.size();
        scans.nodes.push_back(std::move(*node));
        return true;
      });
  found.of(StoreTable::kTie) =
      scan(StoreTable::kTie, kTies, 8, "ties of scans", [&](const SqliteStatement& row) {
        std::optional<Tie> tie = readTie(row);
        if (!tie) return false;
        const auto place = now.find(tie->place);
        const auto node = now.find(tie->node);
        if (place == now.end() || node == now.end()) return true;  // of a scan that is damaged
        tie->place = place->second;
        tie->node = node->second;
        scans.ties.push_back(*tie);
        return true;
      });
  found.of(StoreTable::kWheels) = scan(
      StoreTable::kWheels, kWheels, 3, "errors of the wheels", [&](const SqliteStatement& row) {
        const OdometryErrors errors{row.real(1), row.real(2)};
        if (checksumOf(errors) != static_cast<std::uint64_t>(row.integer(3))) return false;
        scans.errors = errors;
        return true;
      });
  return scans;
}

void writeScans(SqliteDatabase& database, const KeptMap& scans, StoreHead& head) {
  writeNodes(database, scans.nodes, head.totals.of(StoreTable::kNode));
  writeTies(database, scans.ties, head.totals.of(StoreTable::kTie));
  CountedTable wheels(database, "wheels", "id", 4, head.totals.of(StoreTable::kWheels));
  const std::uint64_t checksum = checksumOf(scans.errors);
  wheels.replace(1)
      .bind(std::int64_t{1})
      .bind(scans.errors.bend)
      .bind(scans.errors.turn_factor)
      .bind(static_cast<std::int64_t>(checksum))
      .run();
  wheels.add(checksum);
}

}  // namespace place_memory::core
