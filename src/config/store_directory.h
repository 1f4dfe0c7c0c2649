#ifndef PLACE_MEMORY_CONFIG_STORE_DIRECTORY_H
#define PLACE_MEMORY_CONFIG_STORE_DIRECTORY_H

#include <string>

namespace place_memory::config {

/// The file or folder that a client names, from the root and with links followed: below
/// `directory`, from which it begins where it does not begin with a slash or `~/`. Throws
/// std::invalid_argument that says what to do where it lies elsewhere, be it by "..", from the root
/// or through a link, and where `directory` is empty or not there.
std::string pathInside(const std::string& directory, const std::string& path);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_STORE_DIRECTORY_H
