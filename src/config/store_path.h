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

/// Where a store of this name, which somebody on the network gave, lies in the folder that stores
/// are kept in: below it, links resolved. Whatever would lie elsewhere, be it by "..", a whole path
/// or a link, or would be taken for a part of another store, is refused: throws std::runtime_error
/// that says what is wrong in a sentence. `directory` has to be there.
std::string pathInStoreDirectory(const std::string& directory, const std::string& name);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_STORE_PATH_H
