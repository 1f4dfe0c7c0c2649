#include "core/route/landmarks.h"

#include <gtest/gtest.h>

#include "core/route/route_search.h"
#include "core/route/route_world.h"

namespace place_memory::core {
namespace {

using Vertex = RouteGraph::Vertex;

/// A random map whose places come and go, and whose links become quicker and slower.
class LandmarksTest : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr int kPlaces = 120;

  LandmarksTest() : random_(GetParam()), graph_(LinkLearningOptions{}) {
    std::vector<MapEdit> edits;
    for (PlaceId id = 1; id <= kPlaces; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
    change(edits);
    for (int i = 0; i < 200; ++i) link(upTo(kPlaces), upTo(kPlaces), 5 + upTo(30));
  }

  int upTo(int most) { return std::uniform_int_distribution<int>(1, most)(random_); }

  void change(std::vector<MapEdit> edits) {
    const MapChange change{map_.version() + 1, std::chrono::nanoseconds(0), std::move(edits)};
    map_.apply(change);
    graph_.follow(change, map_);
    landmarks_.follow(change, graph_, map_);
  }

  void link(PlaceId one, PlaceId other, double time) {
    if (one != other && map_.find(one) != nullptr && map_.find(other) != nullptr) {
      change({linkOf(one, other, time)});
    }
  }

  double costOf(const RouteSearch::Way& way) const {
    double cost = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (const RouteGraph::Arc& arc : graph_.arcs(way[i - 1])) {
        if (arc.to == way[i]) cost += static_cast<double>(arc.cost);
      }
    }
    return cost;
  }

  void expectNoDifference() {
    graph_.refresh(map_, std::chrono::nanoseconds(0));
    const Landmarks none;
    for (int i = 0; i < 30; ++i) {
      const PlaceId one = upTo(kPlaces), other = upTo(kPlaces);
      if (map_.find(one) == nullptr || map_.find(other) == nullptr) continue;
      const Vertex from = graph_.vertexOf(one), to = graph_.vertexOf(other);
      const auto plain = search_.find(graph_, none, from, to, {});
      const auto quick = search_.find(graph_, landmarks_, from, to, {});
      ASSERT_EQ(plain.has_value(), quick.has_value());
      if (!plain) continue;
      EXPECT_NEAR(costOf(*plain), costOf(*quick), 1e-3);
      EXPECT_LE(landmarks_.bound(from, to), costOf(*plain) + 1e-3);
    }
  }

  std::mt19937 random_;
  PlaceMap map_;
  RouteGraph graph_;
  Landmarks landmarks_;
  RouteSearch search_;
};

TEST_P(LandmarksTest, ShortenTheSearchAndFindTheSame) {
  landmarks_.prepare(graph_, map_);
  EXPECT_FALSE(landmarks_.areWorn());
  expectNoDifference();
}

TEST_P(LandmarksTest, HoldWhileLinksBecomeQuickerSlowerNewAndGone) {
  landmarks_.prepare(graph_, map_);
  for (int step = 0; step < 40; ++step) {
    link(upTo(kPlaces), upTo(kPlaces), upTo(30));
    const std::vector<PlaceLink> links = map_.links();
    const PlaceLink& some =
        links[static_cast<std::size_t>(upTo(static_cast<int>(links.size()))) - 1];
    LinkDirection quicker = some.forward;
    quicker.time *= step % 2 == 0 ? 0.3 : 3.0;
    change({LinkLearned{some.first, some.second, quicker}});
    if (step % 5 == 0) change({LinkRemoved{some.first, some.second}});
    if (step % 7 == 0 && map_.find(step + 1) != nullptr) change({PlaceRemoved{step + 1}});
    expectNoDifference();
  }
}

// Whole parts of a building are found later, and joined to it by more than one way.
TEST_P(LandmarksTest, HoldWhenIslandsComeToThem) {
  landmarks_.prepare(graph_, map_);
  for (PlaceId first = 1000; first < 1100; first += 10) {
    std::vector<MapEdit> edits;
    for (PlaceId id = first; id < first + 10; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
    for (PlaceId id = first; id < first + 9; ++id) edits.emplace_back(linkOf(id, id + 1, 0.5));
    change(edits);
    link(first, upTo(kPlaces), 1.0);
    link(first + 9, upTo(kPlaces), 1.0);
    link(first + 4, upTo(kPlaces), 1.0);
    expectNoDifference();
  }
  EXPECT_TRUE(landmarks_.areWorn());
  landmarks_.prepare(graph_, map_);
  expectNoDifference();
}

TEST_P(LandmarksTest, GoWithTheMap) {
  landmarks_.prepare(graph_, map_);
  change({MapCleared{}});
  EXPECT_TRUE(landmarks_.empty());
}

INSTANTIATE_TEST_SUITE_P(Seeds, LandmarksTest, testing::Range(1U, 6U));

}  // namespace
}  // namespace place_memory::core
