#include "core/store/packed_edits.h"

#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "core/store/packed_readings.h"

namespace place_memory::core {
namespace {

/// In the bytes: never give one a new meaning.
enum class Kind : std::uint8_t {
  kPlaceAdded = 1,
  kPlaceMoved,
  kPlaceRenamed,
  kGridAdapted,
  kPlaceRemoved,
  kLinkAdded,
  kLinkRemoved,
  kLinkLearned,
  kMapCleared,
};

class Packer {
 public:
  explicit Packer(BytePacker& bytes) : bytes_(bytes) {}

  void operator()(const PlaceAdded& edit) {
    const Place& place = edit.place;
    add(Kind::kPlaceAdded);
    bytes_.add(place.id);
    for (const std::uint8_t byte : place.identity) bytes_.add(byte);
    bytes_.add(place.label);
    add(place.map_from_place);
    bytes_.add(std::int64_t{place.learned.count()}).add(place.session);
    add(place.place_from_robot);
    add(*edit.grid);
    const auto readings = packReadings(edit.readings ? *edit.readings : kNoReadings);
    bytes_.add(std::string(readings.begin(), readings.end()));
  }
  void operator()(const PlaceMoved& edit) {
    add(Kind::kPlaceMoved);
    bytes_.add(edit.id);
    add(edit.map_from_place);
    bytes_.add(edit.session);
  }
  void operator()(const PlaceRenamed& edit) {
    add(Kind::kPlaceRenamed);
    bytes_.add(edit.id).add(edit.label);
  }
  void operator()(const GridAdapted& edit) {
    add(Kind::kGridAdapted);
    bytes_.add(edit.id);
    add(*edit.grid);
  }
  void operator()(const PlaceRemoved& edit) {
    add(Kind::kPlaceRemoved);
    bytes_.add(edit.id);
  }
  void operator()(const LinkAdded& edit) {
    const PlaceLink& link = edit.link;
    add(Kind::kLinkAdded);
    bytes_.add(link.first).add(link.second);
    add(link.first_from_second);
    for (const double element : link.covariance) bytes_.add(element);
    add(link.forward);
    add(link.backward);
  }
  void operator()(const LinkRemoved& edit) {
    add(Kind::kLinkRemoved);
    bytes_.add(edit.first).add(edit.second);
  }
  void operator()(const LinkLearned& edit) {
    add(Kind::kLinkLearned);
    bytes_.add(edit.from).add(edit.to);
    add(edit.direction);
  }
  void operator()(const MapCleared& /*edit*/) { add(Kind::kMapCleared); }

 private:
  void add(Kind kind) { bytes_.add(static_cast<std::uint8_t>(kind)); }
  void add(const Pose2d& pose) { bytes_.add(pose.x).add(pose.y).add(pose.yaw); }
  void add(const LinkDirection& direction) {
    bytes_.add(direction.succeeded).add(direction.failed).add(std::int64_t{direction.last.count()});
    bytes_.add(direction.through).add(direction.blocked).add(direction.time);
    bytes_.add(direction.time_sigma).add(direction.lost_time).add(direction.toll);
    bytes_.add(static_cast<std::uint8_t>(direction.forbidden));
  }
  void add(const EvidenceGrid& grid) {
    for (const std::int8_t cell : grid.cells()) bytes_.add(cell);
  }

  static inline const std::vector<SonarReading> kNoReadings;

  BytePacker& bytes_;
};

class Unpacker {
 public:
  Unpacker(ByteUnpacker& bytes, double cell_size) : bytes_(bytes), cell_size_(cell_size) {}

  std::optional<MapEdit> take() {
    switch (static_cast<Kind>(bytes_.take<std::uint8_t>())) {
      case Kind::kPlaceAdded:
        return takePlace();
      case Kind::kPlaceMoved: {
        PlaceMoved edit{takeId(), takePose(), kNoSession};
        edit.session = takeId();
        return edit;
      }
      case Kind::kPlaceRenamed: {
        const PlaceId id = takeId();
        return PlaceRenamed{id, bytes_.takeText()};
      }
      case Kind::kGridAdapted: {
        const PlaceId id = takeId();
        return GridAdapted{id, takeGrid()};
      }
      case Kind::kPlaceRemoved:
        return PlaceRemoved{takeId()};
      case Kind::kLinkAdded:
        return takeLink();
      case Kind::kLinkRemoved: {
        const PlaceId first = takeId();
        return LinkRemoved{first, takeId()};
      }
      case Kind::kLinkLearned: {
        const PlaceId from = takeId();
        const PlaceId to = takeId();
        return LinkLearned{from, to, takeDirection()};
      }
      case Kind::kMapCleared:
        return MapCleared{};
    }
    return std::nullopt;
  }

 private:
  PlaceId takeId() { return bytes_.take<std::int64_t>(); }
  Pose2d takePose() {
    Pose2d pose;
    pose.x = bytes_.take<double>();
    pose.y = bytes_.take<double>();
    pose.yaw = bytes_.take<double>();
    return pose;
  }
  LinkDirection takeDirection() {
    LinkDirection direction;
    direction.succeeded = bytes_.take<std::uint32_t>();
    direction.failed = bytes_.take<std::uint32_t>();
    direction.last = std::chrono::nanoseconds(bytes_.take<std::int64_t>());
    for (double* number : {&direction.through, &direction.blocked, &direction.time,
                           &direction.time_sigma, &direction.lost_time, &direction.toll}) {
      *number = bytes_.take<double>();
    }
    direction.forbidden = bytes_.take<std::uint8_t>() != 0;
    return direction;
  }
  std::shared_ptr<const EvidenceGrid> takeGrid() {
    auto grid = std::make_shared<EvidenceGrid>(GridGeometry{cell_size_});
    for (std::int8_t& cell : grid->cells()) cell = bytes_.take<std::int8_t>();
    return grid;
  }
  std::optional<MapEdit> takePlace() {
    PlaceAdded edit;
    Place& place = edit.place;
    place.id = takeId();
    for (std::uint8_t& byte : place.identity) byte = bytes_.take<std::uint8_t>();
    place.label = bytes_.takeText();
    place.map_from_place = takePose();
    place.learned = std::chrono::nanoseconds(bytes_.take<std::int64_t>());
    place.session = bytes_.take<std::int64_t>();
    place.place_from_robot = takePose();
    edit.grid = takeGrid();
    const std::string packed = bytes_.takeText();
    auto readings = unpackReadings(packed.data(), packed.size());
    if (!readings) return std::nullopt;
    edit.readings = std::make_shared<const std::vector<SonarReading>>(std::move(*readings));
    return edit;
  }
  MapEdit takeLink() {
    LinkAdded edit;
    edit.link.first = takeId();
    edit.link.second = takeId();
    edit.link.first_from_second = takePose();
    for (double& element : edit.link.covariance) element = bytes_.take<double>();
    edit.link.forward = takeDirection();
    edit.link.backward = takeDirection();
    return edit;
  }

  ByteUnpacker& bytes_;
  double cell_size_;
};

}  // namespace

void packEdits(const std::vector<MapEdit>& edits, BytePacker& bytes) {
  bytes.add(static_cast<std::uint32_t>(edits.size()));
  Packer packer(bytes);
  for (const MapEdit& edit : edits) std::visit(packer, edit);
}

std::optional<std::vector<MapEdit>> unpackEdits(ByteUnpacker& bytes, double cell_size) {
  std::vector<MapEdit> edits;
  Unpacker unpacker(bytes, cell_size);
  for (auto left = bytes.take<std::uint32_t>(); left > 0; --left) {
    std::optional<MapEdit> edit = unpacker.take();
    if (!edit || !bytes.good()) return std::nullopt;
    edits.push_back(std::move(*edit));
  }
  return edits;
}

}  // namespace place_memory::core
