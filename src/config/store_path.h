#ifndef PLACE_MEMORY_CONFIG_STORE_PATH_H
#define PLACE_MEMORY_CONFIG_STORE_PATH_H

#include <string>

namespace place_memory::config {

/// What is wrong with the path of a store; empty: nothing.
std::string checkStorePath(const std::string& path);

/// The path from the root: `~/` is the home folder, anything else that does not begin with a slash
/// lies below the folder that the process was started in, which for a node of roslaunch is the
/// folder ~/.ros. An empty path, which is no store, stays empty. The path must be one that
/// checkStorePath() takes.
std::string absoluteStorePath(const std::string& path);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_STORE_PATH_H
