#ifndef PLACE_MEMORY_TOOLS_CHILD_PROCESS_H
#define PLACE_MEMORY_TOOLS_CHILD_PROCESS_H

#include <functional>
#include <string>

namespace place_memory::tools {

/// Does `work` in a child process, and returns what it returns, the exit status. A damaged bag
/// makes the library that reads it write beyond its memory, which no exception reports: where the
/// child crashes, says so on stderr, then `advice`, and returns EXIT_FAILURE. What ends either of
/// the two from outside ends both. To be called before there is any thread.
int runInChild(const std::function<int()>& work, const std::string& advice);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_CHILD_PROCESS_H
