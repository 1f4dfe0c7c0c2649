#ifndef PLACE_MEMORY_CONFIG_SEARCH_METHODS_H
#define PLACE_MEMORY_CONFIG_SEARCH_METHODS_H

#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/search_method.h"

namespace place_memory::config {

/// Every method with the word that parameter match/method has for it.
const std::vector<std::pair<std::string, core::SearchMethod>>& searchMethods();

const std::string& wordFor(core::SearchMethod method);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_SEARCH_METHODS_H
