#ifndef PLACE_MEMORY_NODE_ANSWER_ANSWER_WORDS_H
#define PLACE_MEMORY_NODE_ANSWER_ANSWER_WORDS_H

#include <cstddef>
#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

std::string quoted(const std::string& label);

/// "1 place", "2 places".
std::string placesInWords(std::size_t count);

/// What a person who asked is told: the verdict, and what it changed or could not change.
std::string inWords(const core::PlaceMemory::Answer& answer);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_ANSWER_WORDS_H
