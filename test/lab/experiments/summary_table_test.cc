#include "experiments/summary_table.h"

#include <gtest/gtest.h>

#include <sstream>

namespace place_memory::experiments {
namespace {

Answer answer(bool known, bool stranger, bool right, core::Verdict verdict) {
  Answer answer;
  answer.known = known;
  answer.stranger = stranger;
  answer.right = right;
  answer.verdict = verdict;
  return answer;
}

TEST(VerdictShareTable, CountsEachKindOfScanOfTheMethodByItself) {
  using core::Verdict;
  const Experiment experiment{};
  Method asked, other;
  asked.name = "asked";
  other.name = "other";
  const std::vector<Outcome> outcomes{
      {&experiment,
       &asked,
       {answer(true, false, true, Verdict::kRecognized),
        answer(true, false, true, Verdict::kAmbiguous),
        answer(true, false, false, Verdict::kAmbiguous),
        answer(false, true, false, Verdict::kUnknown)}},
      {&experiment, &other, {answer(true, false, false, Verdict::kRecognized)}},
      {&experiment,
       &asked,
       {answer(true, false, true, Verdict::kRecognized),
        answer(true, false, true, Verdict::kUnknown)}}};
  std::ostringstream csv;
  verdictShareTable(outcomes, "asked").writeCsv(csv);
  EXPECT_EQ(csv.str(),
            "scan of,scans,RECOGNIZED,AMBIGUOUS,UNKNOWN\n"
            "\"learned place, best match right\",4,0.500,0.250,0.250\n"
            "\"learned place, best match wrong\",1,0.000,1.000,0.000\n"
            "\"place of the building, never learned\",0,,,\n"
            "place of another building,1,0.000,0.000,1.000\n");
}

}  // namespace
}  // namespace place_memory::experiments
