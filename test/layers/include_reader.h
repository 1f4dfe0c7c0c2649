#ifndef PLACE_MEMORY_TEST_LAYERS_INCLUDE_READER_H
#define PLACE_MEMORY_TEST_LAYERS_INCLUDE_READER_H

#include <filesystem>
#include <string>
#include <vector>

namespace place_memory::layers {

/// Root of the package.
extern const std::filesystem::path kRoot;

std::string contents(const std::filesystem::path& file);

/// What the text includes, in quotes or brackets, in its order.
std::vector<std::string> includesIn(const std::string& text);

/// The headers and sources below a folder of the package, as paths from the root, sorted. None
/// where the folder is missing.
std::vector<std::string> sourcesBelow(const std::string& folder);

}  // namespace place_memory::layers

#endif  // PLACE_MEMORY_TEST_LAYERS_INCLUDE_READER_H
