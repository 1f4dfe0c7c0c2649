#include "node/map/map_messages.h"

#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "node/map/map_fixture.h"
#include "place_memory/core/place_map.h"

namespace place_memory::node {
namespace {

constexpr char kFrame[] = "map";

core::MapSnapshot snapshotOf(const core::PlaceMap& map) {
  return {map.version(), map.stamp(), map.places(), map.links()};
}

TEST(ToMessage, APlaceKeepsEverything) {
  core::Place place = makePlace(4, "kitchen", 1.5);
  place.session = 3;
  place.place_from_robot = {0.25, -0.5, 1.0};
  place.identity = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 255};
  const Place message = toMessage(place);
  EXPECT_EQ(message.id, 4);
  EXPECT_EQ(message.label, "kitchen");
  EXPECT_EQ(message.location.x, 1.5);
  EXPECT_EQ(message.location.y, 2.0);
  EXPECT_NEAR(message.location.theta, 0.5, 1e-12);
  EXPECT_EQ(message.learned, ros::Time(12, 345000000));
  EXPECT_EQ(message.session, 3);
  EXPECT_EQ(message.robot.x, 0.25);
  EXPECT_EQ(message.robot.y, -0.5);
  EXPECT_NEAR(message.robot.theta, 1.0, 1e-12);
  EXPECT_TRUE(std::equal(place.identity.begin(), place.identity.end(), message.identity.begin()));
}

TEST(ToMessage, ALinkKeepsEverything) {
  core::PlaceLink link = makeLink(2, 7);
  link.forward = {3, 1, std::chrono::seconds(9), 2.5, 0.5, 6.0, 1.5, 20.0, 4.0, true};
  link.backward = {0, 2, std::chrono::seconds(8)};
  const PlaceLink message = toMessage(link);
  EXPECT_EQ(message.first_id, 2);
  EXPECT_EQ(message.second_id, 7);
  EXPECT_EQ(message.transform.x, 3.0);
  EXPECT_EQ(message.transform.y, 0.25);
  EXPECT_NEAR(message.transform.theta, -0.5, 1e-12);
  EXPECT_TRUE(
      std::equal(link.covariance.begin(), link.covariance.end(), message.covariance.begin()));
  EXPECT_EQ(message.forward.succeeded, 3U);
  EXPECT_EQ(message.forward.failed, 1U);
  EXPECT_EQ(message.forward.last, ros::Time(9, 0));
  EXPECT_EQ(message.forward.through, 2.5);
  EXPECT_EQ(message.forward.blocked, 0.5);
  EXPECT_EQ(message.forward.time, 6.0);
  EXPECT_EQ(message.forward.time_sigma, 1.5);
  EXPECT_EQ(message.forward.lost_time, 20.0);
  EXPECT_EQ(message.forward.toll, 4.0);
  EXPECT_TRUE(message.forward.forbidden);
  EXPECT_FALSE(message.backward.forbidden);
  EXPECT_EQ(message.backward.succeeded, 0U);
  EXPECT_EQ(message.backward.failed, 2U);
  EXPECT_EQ(message.backward.last, ros::Time(8, 0));
}

TEST(ToMessage, AGraphKeepsPlacesLinksVersionAndStamp) {
  const PlaceGraph message = toMessage(makeChain(), kFrame);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(7, 8));
  EXPECT_EQ(message.version, 5U);
  ASSERT_EQ(message.places.size(), 3U);
  EXPECT_EQ(message.places[2].label, "c");
  ASSERT_EQ(message.links.size(), 2U);
  EXPECT_EQ(message.links[1].first_id, 2);
  EXPECT_EQ(message.links[1].second_id, 3);
}

TEST(ToMessage, AnAdaptedGridIsNamed) {
  core::MapChange change;
  change.edits = {core::GridAdapted{7, nullptr}};
  EXPECT_EQ(toMessage(change, kFrame).adapted, std::vector<std::int64_t>{7});
}

TEST(ToMessage, WhatIsAddedAndRemovedInOneChangeIsNotTold) {
  core::MapChange change;
  change.edits = {core::PlaceAdded{makePlace(9, "i", 0.0), nullptr, nullptr},
                  core::LinkAdded{makeLink(1, 9)}, core::PlaceRemoved{9}};
  const MapChange message = toMessage(change, kFrame);
  EXPECT_TRUE(message.added.empty() && message.removed.empty() && message.linked.empty());
}

// Does what MapChange.msg says, as a client would.
class Client {
 public:
  void apply(const MapChange& change) {
    ASSERT_EQ(change.version, version + 1);
    version = change.version;
    stamp = change.header.stamp;
    if (change.cleared != 0) {
      places.clear();
      links.clear();
    }
    for (const std::int64_t id : change.removed) remove(id);
    for (std::size_t i = 0; i < change.unlinked_first.size(); ++i) {
      links.erase({change.unlinked_first[i], change.unlinked_second.at(i)});
    }
    for (const Place& place : change.added) places[place.id] = place;
    for (std::size_t i = 0; i < change.moved.size(); ++i) {
      Place& place = places.at(change.moved[i]);
      place.location = change.moved_locations.at(i);
      place.session = change.moved_sessions.at(i);
    }
    for (std::size_t i = 0; i < change.renamed.size(); ++i) {
      places.at(change.renamed[i]).label = change.new_labels.at(i);
    }
    for (const PlaceLink& link : change.linked) links[{link.first_id, link.second_id}] = link;
    for (std::size_t i = 0; i < change.travelled.size(); ++i) {
      const std::int64_t from = change.travelled_from.at(i);
      const std::int64_t to = change.travelled_to.at(i);
      PlaceLink& link = links.at(std::minmax(from, to));
      (from < to ? link.forward : link.backward) = change.travelled[i];
    }
  }

  PlaceGraph graph() const {
    PlaceGraph graph;
    graph.header.frame_id = kFrame;
    graph.header.stamp = stamp;
    graph.version = version;
    for (const auto& [id, place] : places) graph.places.push_back(place);
    for (const auto& [ends, link] : links) graph.links.push_back(link);
    return graph;
  }

  std::uint64_t version = 0;
  ros::Time stamp;
  std::map<std::int64_t, Place> places;
  std::map<std::pair<std::int64_t, std::int64_t>, PlaceLink> links;

 private:
  void remove(std::int64_t id) {
    places.erase(id);
    for (auto at = links.begin(); at != links.end();) {
      const bool goes = at->first.first == id || at->first.second == id;
      at = goes ? links.erase(at) : std::next(at);
    }
  }
};

// Makes changes of several edits that fit a map, whatever its state.
class Editor {
 public:
  explicit Editor(unsigned seed) : random_(seed) {}

  core::MapChange next(const core::PlaceMap& map) {
    core::MapChange change;
    change.version = map.version() + 1;
    change.stamp = std::chrono::seconds(change.version);
    core::PlaceMap after = map;
    const int edits = upTo(5) + 1;
    while (static_cast<int>(change.edits.size()) < edits) {
      const core::MapEdit edit = propose(after);
      core::MapChange step;
      step.version = after.version() + 1;
      step.edits = {edit};
      try {
        after.apply(step);
      } catch (const std::invalid_argument&) {
        continue;  // such as a link to itself
      }
      change.edits.push_back(edit);
    }
    return change;
  }

 private:
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

  core::PlaceId anyPlace(const core::PlaceMap& map) {
    if (map.size() == 0) return core::kNoPlace;
    return map.places()[static_cast<std::size_t>(upTo(static_cast<int>(map.size()) - 1))].id;
  }

  core::PlaceLink anyLink(const core::PlaceMap& map) {
    const std::vector<core::PlaceLink> links = map.links();
    if (links.empty()) return {};
    return links[static_cast<std::size_t>(upTo(static_cast<int>(links.size()) - 1))];
  }

  core::MapEdit propose(const core::PlaceMap& map) {
    const core::PlaceLink link = anyLink(map);
    switch (upTo(map.size() < 4 ? 2 : 15)) {
      case 0:
      case 1:
      case 2:
        ++ids_;
        return core::PlaceAdded{makePlace(ids_, "place " + std::to_string(ids_), 1.5), nullptr,
                                nullptr};
      case 3:
      case 4:
        return core::PlaceMoved{anyPlace(map), {0.5 * upTo(9), 1.0, 0.25}, upTo(2) + 1};
      case 5:
      case 6:
        return core::PlaceRenamed{anyPlace(map), "name " + std::to_string(upTo(9))};
      case 7:
        return core::GridAdapted{anyPlace(map), nullptr};
      case 8:
        return core::PlaceRemoved{anyPlace(map)};
      case 9:
        return core::LinkRemoved{link.first, link.second};
      case 10:
        return core::LinkLearned{link.first, link.second, {1, 2, std::chrono::seconds(upTo(9))}};
      case 11:
        return core::LinkLearned{link.second, link.first, {3, 4, std::chrono::seconds(upTo(9))}};
      case 12:
        if (upTo(9) == 0) return core::MapCleared{};
        [[fallthrough]];
      default:
        const auto [first, second] = std::minmax({anyPlace(map), anyPlace(map)});
        return core::LinkAdded{makeLink(first, second)};
    }
  }

  std::mt19937 random_;
  core::PlaceId ids_ = 0;
};

TEST(ToMessage, WhoFollowsTheChangesHasTheWholeMap) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Editor editor(seed);
    core::PlaceMap map;
    Client client;
    for (int i = 0; i < 60; ++i) {
      const core::MapChange change = editor.next(map);
      map.apply(change);
      client.apply(toMessage(change, kFrame));
      ASSERT_EQ(client.graph(), toMessage(snapshotOf(map), kFrame)) << seed << ", " << i;
    }
  }
}

TEST(ToMessage, AChangeOfOnePlaceIsSmallHoweverLargeTheMap) {
  core::MapChange change;
  change.edits = {core::PlaceAdded{makePlace(100000, std::string(255, 'x'), 0.0),
                                   std::make_shared<core::EvidenceGrid>(), nullptr},
                  core::LinkAdded{makeLink(99999, 100000)}};
  const auto bytes = ros::serialization::serializationLength(toMessage(change, kFrame));
  RecordProperty("bytes", static_cast<int>(bytes));
  EXPECT_LT(bytes, 1000U);
}

}  // namespace
}  // namespace place_memory::node
