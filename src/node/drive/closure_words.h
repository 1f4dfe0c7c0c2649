#ifndef PLACE_MEMORY_NODE_DRIVE_CLOSURE_WORDS_H
#define PLACE_MEMORY_NODE_DRIVE_CLOSURE_WORDS_H

#include <place_memory/ClosureCandidate.h>

#include <cstdint>
#include <string>

#include "core/mapping/closure_question.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

struct ClosureReply {
  std::uint8_t status;  ///< of JudgeClosure
  std::string message;
};

/// What to answer a person who confirmed a closure, or cut it.
ClosureReply replyTo(core::ClosureWord word, bool confirm);

ClosureCandidate toMessage(const core::ClosureQuestion& question, const core::PlaceMemory& memory);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_CLOSURE_WORDS_H
