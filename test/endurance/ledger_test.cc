#include "endurance/ledger.h"

#include <gtest/gtest.h>

#include "core/store/store_fixture.h"
#include "core/temporary_folder.h"

namespace place_memory {
namespace {

using What = Said::What;

MapRecord mapOf(std::uint64_t version, const std::vector<std::string>& labels) {
  MapRecord map;
  map.version = version;
  for (const std::string& label : labels) {
    core::Place place = core::makePlace(label);
    place.id = static_cast<core::PlaceId>(map.places.size() + 1);
    map.grids[place.id] = map.places.size() + 77;
    map.places.push_back(place);
  }
  if (labels.size() > 1) map.links.push_back(core::makeLink(1, 2));
  return map;
}

Said say(What what, const MapRecord& map) {
  Said said;
  said.what = what;
  said.map = map;
  return said;
}

Said say(What what, Deed deed, const std::string& label, const std::string& new_label = "") {
  Said said;
  said.what = what;
  said.deed = deed;
  said.text = label;
  said.new_text = new_label;
  return said;
}

// A client learned a and b, and is asking for c.
Ledger ledgerOfTwo() {
  Ledger ledger;
  ledger.add(say(What::kOpened, mapOf(0, {})));
  for (const std::string label : {"a", "b"}) {
    ledger.add(say(What::kAsked, Deed::kLearn, label));
    ledger.add(say(What::kChanged, label == "a" ? mapOf(1, {"a"}) : mapOf(2, {"a", "b"})));
    ledger.add(say(What::kAnswered, Deed::kLearn, label));
  }
  ledger.add(say(What::kAsked, Deed::kLearn, "c"));
  return ledger;
}

TEST(Ledger, FindsNothingWhereAllIsThere) {
  Ledger ledger = ledgerOfTwo();
  ledger.add(say(What::kOpened, mapOf(2, {"a", "b"})));
  EXPECT_TRUE(ledger.problems().empty());
  EXPECT_EQ(ledger.acknowledged(), 2);
  EXPECT_EQ(ledger.untold(), 0);
}

TEST(Ledger, AllowsTheOneChangeThatWasUnderWay) {
  Ledger ledger = ledgerOfTwo();
  ledger.add(say(What::kOpened, mapOf(3, {"a", "b", "c"})));
  EXPECT_TRUE(ledger.problems().empty());
  EXPECT_EQ(ledger.untold(), 1);
}

TEST(Ledger, FindsEveryKindOfLoss) {
  MapRecord moved = mapOf(2, {"a", "b"});
  moved.places[1].map_from_place.x += 1e-12;
  MapRecord unlinked = mapOf(2, {"a", "b"});
  unlinked.links.clear();
  MapRecord faded = mapOf(2, {"a", "b"});
  faded.grids[2] = 1;
  for (const MapRecord& found :
       {mapOf(1, {"a"}), mapOf(3, {"a", "b", "d"}), mapOf(4, {"a", "b", "c"}), mapOf(3, {"a", "c"}),
        moved, unlinked, faded}) {
    Ledger ledger = ledgerOfTwo();
    ledger.add(say(What::kOpened, found));
    EXPECT_EQ(ledger.problems().size(), 1U);
  }
}

TEST(Ledger, FindsWhatWasAcknowledgedTooEarly) {
  for (const Said& said :
       {say(What::kAnswered, Deed::kLearn, "c"), say(What::kAnswered, Deed::kRemove, "a"),
        say(What::kAnswered, Deed::kRename, "a", "e")}) {
    Ledger ledger = ledgerOfTwo();
    ledger.add(said);
    EXPECT_EQ(ledger.problems().size(), 1U);
  }
}

TEST(ChangeLog, KeepsWhatWasSaidWholly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("log");
  {
    ChangeLog log(path);
    log.say(say(What::kAsked, Deed::kRename, "a", "b"));
    log.say(say(What::kChanged, mapOf(2, {"a", "b"})));
  }
  const std::string whole = readFile(path);
  const std::vector<Said> said = ChangeLog::read(path);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].new_text, "b");
  EXPECT_EQ(difference(mapOf(2, {"a", "b"}), said[1].map), "");
  writeFile(path, whole.substr(0, whole.size() - 1));
  EXPECT_EQ(ChangeLog::read(path).size(), 1U);
}

}  // namespace
}  // namespace place_memory
