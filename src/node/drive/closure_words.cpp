#include "node/drive/closure_words.h"

#include <place_memory/JudgeClosure.h>

namespace place_memory::node {

ClosureReply replyTo(core::ClosureWord word, bool confirm) {
  using Answer = JudgeClosure::Response;
  switch (word) {
    case core::ClosureWord::kNoQuestion:
      return {Answer::NO_CANDIDATE,
              confirm
                  ? "no scans say that the robot is there: see `waiting`, or say by initialpose "
                    "where it is"
                  : "no scans say that the robot is there, and no closure there is new: see "
                    "`waiting`"};
    case core::ClosureWord::kRefused:
      return {Answer::REFUSED,
              "the map speaks against it: what was tied before would be torn; drive on there, or "
              "say by initialpose where the robot is"};
    case core::ClosureWord::kDone:
      break;
  }
  return {Answer::OK, confirm ? "the robot is there: the map follows"
                              : "the robot is not there: nothing comes of it while scans say so"};
}

ClosureCandidate toMessage(const core::ClosureQuestion& question, const core::PlaceMemory& memory) {
  ClosureCandidate message;
  message.id = question.place;
  const auto place = memory.place(question.place);
  if (place) message.label = place->label;
  message.scans = static_cast<std::uint32_t>(question.scans);
  message.sentence = question.evidence;
  return message;
}

}  // namespace place_memory::node
