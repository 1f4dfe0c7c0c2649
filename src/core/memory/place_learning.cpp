#include <cmath>

#include "core/map/link_odds.h"
#include "core/map/place_identity.h"
#include "core/map/place_label.h"
#include "core/memory/link_pose.h"
#include "core/memory/place_memory_impl.h"
#include "core/sensing/scan_echoes.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;

// Cell sizes that went through text, as in a YAML file, may differ in the last digits.
constexpr double kCellSizeTolerance = 1e-9;  // [m]

constexpr char kApart[] =
    "where it lies beside the places known before is not known, because none of them was "
    "recognised "
    "since odometry began anew: recognise one, and it moves to where it belongs";

[[noreturn]] void refuseWithoutEcho() {
  throw PlaceMemoryError(
      Reason::kNoEcho,
      "no echo lies in the scan's grid, so that nothing can be recognized by it: scan where walls "
      "or furniture are in reach, see to the sensors and the unit of their ranges, or learn it "
      "with "
      "force");
}

}  // namespace

void refuseLabel() {
  throw PlaceMemoryError(Reason::kInvalidLabel,
                         "a label has 1 to " + std::to_string(kMaxLabelBytes) +
                             " bytes of UTF-8 text without control characters");
}

std::string newLabel(const PlaceMap& map, const std::string& wanted) {
  if (!wanted.empty()) {
    if (!isValidLabel(wanted)) refuseLabel();
    if (map.find(wanted) != nullptr) {
      throw PlaceMemoryError(Reason::kLabelTaken,
                             "another place has the label \"" + wanted + "\"; give another one");
    }
    return wanted;
  }
  PlaceId number = map.lastId() + 1;
  std::string label = "place " + std::to_string(number);
  while (map.find(label) != nullptr) label = "place " + std::to_string(++number);
  return label;
}

void PlaceMemory::Impl::check(const Scan& scan) const {
  const double cell_size = scan.grid.geometry().cell_size;
  // Written so that NaN fails.
  if (!(std::abs(cell_size - cell_size_) <= kCellSizeTolerance)) {
    throw PlaceMemoryError(Reason::kWrongCells,
                           "the scan has cells of " + std::to_string(cell_size) +
                               " m, the memory's are " + std::to_string(cell_size_) +
                               " m: make scans with cells of that size, or name another store");
  }
  if (!scan.odom_from_scan.isFinite() || !scan.robot_in_scan.isFinite()) {
    throw PlaceMemoryError(Reason::kInvalidScan, "the location of the scan is not finite");
  }
}

PlaceMemory::Learned PlaceMemory::Impl::learn(const Scan& scan, const std::string& label,
                                              bool force) {
  check(scan);
  if (!force && !scan.doubt.empty()) {
    throw PlaceMemoryError(Reason::kDoubtfulScan, "the scan is not to be relied on: " + scan.doubt +
                                                      "; scan again, or learn it with force");
  }
  if (!force && !holdsEcho(scan)) refuseWithoutEcho();
  std::uint64_t question = 0;
  {
    const std::lock_guard<std::mutex> lock(state_.mutex);
    question = state_.whereabouts.ask();
  }
  return queue_.run([&] { return learnNow(scan, label, question); });
}

PlaceMemory::Learned PlaceMemory::Impl::learnNow(const Scan& scan, const std::string& label,
                                                 std::uint64_t question) {
  Learned result;
  Place& place = result.place;
  place.label = newLabel(state_.map, label);
  const Place* same = state_.map.find(learned_scans_.find(scan));
  if (same != nullptr) {
    throw PlaceMemoryError(Reason::kAlreadyLearned, "this scan is the place \"" + same->label +
                                                        "\" already: make another scan");
  }
  const SessionId next_session = writer_.query([&](PlaceStore& store) {
    place.id = store.nextId();
    return store.nextSession();
  });
  const Footing footing =
      read([&](const MemoryState& state) { return state.whereabouts.footing(next_session); });
  place.identity = makePlaceIdentity();
  place.map_from_place = footing.map_from_odom * scan.odom_from_scan;
  place.learned = scan.end;
  place.session = footing.driven && !footing.apart ? mapSession() : footing.session;
  place.place_from_robot = scan.robot_in_scan;

  std::vector<MapEdit> edits{
      PlaceAdded{place, std::make_shared<const EvidenceGrid>(scan.grid),
                 std::make_shared<const std::vector<SonarReading>>(scan.readings)}};
  const auto& previous = footing.previous;
  if (previous && state_.map.find(previous->place) != nullptr) {
    LinkAdded edit{linkTo(place.id, scan.odom_from_scan, *previous, located_, scan.end), {}};
    PlaceLink& link = edit.link;
    link.forward = {};
    // A drive tells of the way itself.
    if (!footing.driven) {
      edit.traversal =
          read([&](const MemoryState&) { return wayTo(scan, previous->place, place.id); });
      link.forward = learned(link.forward, *edit.traversal,
                             expectedTime(link, link.forward, links_), links_.half_life);
    }
    edits.emplace_back(std::move(edit));
  }
  std::optional<SessionJoin> joined;
  writer_.commit(std::move(edits), [&] {
    joined = state_.whereabouts.learned(question, footing, place, scan.odom_from_scan);
    stood_ = {place.id, scan.end};
  });
  learned_scans_.add(scan, place.id);
  if (joined) {
    std::vector<MapEdit> moves;
    join(*joined, moves);
    writer_.commit(std::move(moves));
    place = *state_.map.find(place.id);
  }
  result.apart = footing.apart && !joined;
  if (result.apart) result.message = kApart;
  return result;
}

}  // namespace place_memory::core
