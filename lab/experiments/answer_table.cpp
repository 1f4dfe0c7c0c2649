#include "experiments/answer_table.h"

namespace place_memory::experiments {

Table answerTable(const std::vector<Outcome>& outcomes) {
  Table table({"experiment", "case", "method", "seed", "known", "stranger", "expected", "given",
               "right", "verdict", "probability", "position_error", "heading_error",
               "normalised_error"});
  for (const Outcome& outcome : outcomes) {
    for (const Answer& answer : outcome.answers) {
      table.add({outcome.experiment->group, outcome.experiment->name, outcome.method->name,
                 std::to_string(answer.seed), answer.known ? "1" : "0", answer.stranger ? "1" : "0",
                 answer.expected, answer.given, answer.right ? "1" : "0",
                 core::nameOf(answer.verdict), fixed(answer.probability, 6),
                 fixed(answer.position_error, 4), fixed(answer.heading_error, 4),
                 fixed(answer.normalised_error, 4)});
    }
  }
  return table;
}

}  // namespace place_memory::experiments
