#include "endurance/map_record.h"

#include <algorithm>

#include "core/store/packed_bytes.h"
#include "core/store/row_checksum.h"

namespace place_memory {
namespace {

using core::BytePacker;
using core::ByteUnpacker;

void add(BytePacker& bytes, const core::Pose2d& pose) {
  bytes.add(pose.x).add(pose.y).add(pose.yaw);
}

void add(BytePacker& bytes, const core::LinkDirection& direction) {
  bytes.add(direction.succeeded).add(direction.failed).add(std::int64_t{direction.last.count()});
  bytes.add(direction.through).add(direction.blocked).add(direction.time);
  bytes.add(direction.time_sigma).add(direction.lost_time).add(direction.toll);
  bytes.add(static_cast<std::uint8_t>(direction.forbidden));
}

void add(BytePacker& bytes, const core::Place& place) {
  bytes.add(place.id);
  for (const std::uint8_t byte : place.identity) bytes.add(byte);
  bytes.add(static_cast<std::uint32_t>(place.label.size()));
  for (const char letter : place.label) bytes.add(static_cast<std::uint8_t>(letter));
  add(bytes, place.map_from_place);
  bytes.add(std::int64_t{place.learned.count()}).add(place.session);
  add(bytes, place.place_from_robot);
}

void add(BytePacker& bytes, const core::PlaceLink& link) {
  bytes.add(link.first).add(link.second);
  add(bytes, link.first_from_second);
  for (const double element : link.covariance) bytes.add(element);
  add(bytes, link.forward);
  add(bytes, link.backward);
}

core::Pose2d takePose(ByteUnpacker& bytes) {
  core::Pose2d pose;
  pose.x = bytes.take<double>();
  pose.y = bytes.take<double>();
  pose.yaw = bytes.take<double>();
  return pose;
}

core::LinkDirection takeDirection(ByteUnpacker& bytes) {
  core::LinkDirection direction;
  direction.succeeded = bytes.take<std::uint32_t>();
  direction.failed = bytes.take<std::uint32_t>();
  direction.last = std::chrono::nanoseconds(bytes.take<std::int64_t>());
  for (double* number : {&direction.through, &direction.blocked, &direction.time,
                         &direction.time_sigma, &direction.lost_time, &direction.toll}) {
    *number = bytes.take<double>();
  }
  direction.forbidden = bytes.take<std::uint8_t>() != 0;
  return direction;
}

core::Place takePlace(ByteUnpacker& bytes) {
  core::Place place;
  place.id = bytes.take<core::PlaceId>();
  for (std::uint8_t& byte : place.identity) byte = bytes.take<std::uint8_t>();
  place.label.resize(std::min<std::size_t>(bytes.take<std::uint32_t>(), bytes.left()));
  for (char& letter : place.label) letter = static_cast<char>(bytes.take<std::uint8_t>());
  place.map_from_place = takePose(bytes);
  place.learned = std::chrono::nanoseconds(bytes.take<std::int64_t>());
  place.session = bytes.take<core::SessionId>();
  place.place_from_robot = takePose(bytes);
  return place;
}

core::PlaceLink takeLink(ByteUnpacker& bytes) {
  core::PlaceLink link;
  link.first = bytes.take<core::PlaceId>();
  link.second = bytes.take<core::PlaceId>();
  link.first_from_second = takePose(bytes);
  for (double& element : link.covariance) element = bytes.take<double>();
  link.forward = takeDirection(bytes);
  link.backward = takeDirection(bytes);
  return link;
}

}  // namespace

std::uint64_t hashOf(const core::EvidenceGrid& grid) {
  return core::RowChecksum().add(grid.cells().data(), grid.cells().size()).value();
}

MapRecord recordOf(const core::PlaceStore& store) {
  const core::PlaceMap map = store.map();
  MapRecord record;
  record.version = map.version();
  record.places = map.places();
  record.links = map.links();
  for (const core::Place& place : record.places) {
    record.grids[place.id] = hashOf(store.grid(place.id));
  }
  return record;
}

std::string packed(const MapRecord& map) {
  BytePacker bytes;
  bytes.add(map.version).add(static_cast<std::uint32_t>(map.places.size()));
  for (const core::Place& place : map.places) add(bytes, place);
  bytes.add(static_cast<std::uint32_t>(map.links.size()));
  for (const core::PlaceLink& link : map.links) add(bytes, link);
  bytes.add(static_cast<std::uint32_t>(map.grids.size()));
  for (const auto& [id, hash] : map.grids) bytes.add(id).add(hash);
  return {bytes.bytes().begin(), bytes.bytes().end()};
}

std::optional<MapRecord> unpackedMap(const std::string& text) {
  ByteUnpacker bytes(text.data(), text.size());
  MapRecord map;
  map.version = bytes.take<std::uint64_t>();
  for (auto left = bytes.take<std::uint32_t>(); left > 0 && bytes.good(); --left) {
    map.places.push_back(takePlace(bytes));
  }
  for (auto left = bytes.take<std::uint32_t>(); left > 0 && bytes.good(); --left) {
    map.links.push_back(takeLink(bytes));
  }
  for (auto left = bytes.take<std::uint32_t>(); left > 0 && bytes.good(); --left) {
    const auto id = bytes.take<core::PlaceId>();
    map.grids[id] = bytes.take<std::uint64_t>();
  }
  if (!bytes.good() || bytes.left() > 0) return std::nullopt;
  return map;
}

std::string difference(const MapRecord& expected, const MapRecord& found) {
  if (expected == found) return "";
  std::string text = "version " + std::to_string(found.version) + " and not " +
                     std::to_string(expected.version) + ", " + std::to_string(found.places.size()) +
                     " places (" + std::to_string(expected.places.size()) + "), " +
                     std::to_string(found.links.size()) + " links (" +
                     std::to_string(expected.links.size()) + ")";
  const auto has = [](const auto& all, const auto& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  for (const core::Place& place : expected.places) {
    if (!has(found.places, place)) text += "; \"" + place.label + "\" is gone or another";
  }
  for (const core::Place& place : found.places) {
    if (!has(expected.places, place)) text += "; \"" + place.label + "\" is new";
  }
  for (const core::PlaceLink& link : expected.links) {
    if (has(found.links, link)) continue;
    text += "; the link of " + std::to_string(link.first) + " and " + std::to_string(link.second) +
            " is gone or another";
  }
  if (expected.grids != found.grids) text += "; grids differ";
  return text;
}

}  // namespace place_memory
