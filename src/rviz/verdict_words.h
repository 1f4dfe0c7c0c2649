#ifndef PLACE_MEMORY_RVIZ_VERDICT_WORDS_H
#define PLACE_MEMORY_RVIZ_VERDICT_WORDS_H

#include <place_memory/Recognition.h>

#include <cstddef>
#include <string>

namespace place_memory::panel {

/// E.g. "41 %".
std::string percent(double probability);

/// E.g. "1 place", "2 places".
std::string counted(std::size_t count, const std::string& thing);

/// The answer in a sentence; where it names no place, why not.
std::string verdictInWords(const Recognition& recognition);

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_VERDICT_WORDS_H
