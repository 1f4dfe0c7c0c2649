#include "tools/report_page.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/random_room.h"
#include "core/temporary_folder.h"
#include "support/text.h"

namespace place_memory::tools {
namespace {

constexpr char kEvil[] = "<script>alert('\"&\")</script>";

ReportedEvent reported(Action action, const std::string& label) {
  ReportedEvent event;
  event.number = 1;
  event.event.action = action;
  event.event.start = ros::Time(1000.0);
  event.event.end = ros::Time(1003.5);
  event.result.status = "ok";
  event.result.place = label;
  event.left_out = "2 no transform";
  event.scan = std::make_shared<core::Scan>(core::RandomRoom(1).scanFrom({}));
  return event;
}

class ReportPageTest : public testing::Test {
 protected:
  std::string written(const ReportedEvent& event, const core::MapSnapshot& map = {}) {
    ReportPage page(folder_.file("r.html"), "the bag a<b.bag", {"a note & more"});
    page.add(event);
    page.finish(map, nullptr, core::kDefaultCellSize);
    return support::readWholeFile(folder_.file("r.html"));
  }

  TemporaryFolder folder_;
};

TEST_F(ReportPageTest, SaysWhatWasLearned) {
  const std::string page = written(reported(Action::kLearn, "kitchen"));
  for (const char* text :
       {"learned as <b>kitchen</b>", "From 1000.000 to 1003.500 s", "2 no transform", "<svg",
        "the bag a&lt;b.bag", "a note &amp; more", "<th>events</th><td>1</td>", "</html>"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

TEST_F(ReportPageTest, ShowsTheMatchAndTheRunnersUp) {
  ReportedEvent event = reported(Action::kRecognize, "kitchen");
  event.result.verdict = "recognized";
  event.result.matched = true;
  event.result.probability = 0.9876;
  event.result.foremost = {{"kitchen", 0.9876, 12.5}, {"hall", 0.01, 3.25}};
  event.place = event.scan->grid;
  const std::string page = written(event);
  for (const char* text : {"RECOGNIZED: it is <b>kitchen</b> at a probability of 0.988",
                           "<td>hall</td><td>0.010</td>", "laid where it aligns"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

TEST_F(ReportPageTest, SaysWhyThereIsNoAnswer) {
  ReportedEvent event = reported(Action::kRecognize, "");
  event.result.status = "too_few_readings";
  event.result.message = "is anything published on sonar?";
  event.scan = nullptr;
  const std::string page = written(event);
  EXPECT_NE(page.find("no answer: too_few_readings"), std::string::npos);
  EXPECT_NE(page.find("is anything published on sonar?"), std::string::npos);
  EXPECT_EQ(page.find("<figure>"), std::string::npos);
}

TEST_F(ReportPageTest, DrawsTheMapASessionAPicture) {
  core::MapSnapshot map;
  for (int i = 1; i <= 3; ++i) {
    core::Place place;
    place.id = static_cast<core::PlaceId>(i);
    place.label = "p" + std::to_string(i);
    place.map_from_place = {2.0 * i, 1.0, 0.0};
    place.session = static_cast<core::SessionId>(i < 3 ? 1 : 2);
    map.places.push_back(place);
  }
  core::PlaceLink link;
  link.first = 1;
  link.second = 2;
  map.links.push_back(link);
  const std::string page = written(reported(Action::kLearn, "p1"), map);
  for (const char* text : {"Session 1: 2 places", "Session 2: 1 place<", "<line x1=\"2.000\"",
                           ">p3</text>", "<th>links</th><td>1</td>"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

TEST_F(ReportPageTest, TextIsNeverMarkup) {
  ReportedEvent event = reported(Action::kRecognize, kEvil);
  event.result.verdict = "unknown";
  event.result.matched = true;
  event.result.foremost = {{kEvil, 0.1, 1.0}, {kEvil, 0.1, 1.0}};
  event.result.message = kEvil;
  event.problem = kEvil;
  event.left_out = kEvil;
  core::MapSnapshot map;
  map.places.resize(1);
  map.places[0].label = kEvil;
  const std::string page = written(event, map);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;&quot;&amp;&quot;)"), std::string::npos);
}

TEST(ReportPage, AFileThatCannotBeWrittenIsNamed) {
  try {
    const ReportPage page("/nowhere/r.html", "the bag", {});
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot write the report /nowhere/r.html");
  }
}

}  // namespace
}  // namespace place_memory::tools
