#ifndef PLACE_MEMORY_SUPPORT_PARALLEL_FOR_H
#define PLACE_MEMORY_SUPPORT_PARALLEL_FOR_H

#include <cstddef>
#include <functional>

namespace place_memory::support {

/// Calls work(0) to work(count - 1), in any order, from so many threads (0: as many as the
/// processor runs), the caller's among them. After each, `done`, where given, is called with how
/// many are done, one call at a time. Once a call throws none is begun any more; those that were
/// are ended, and what was thrown first is thrown here.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work,
                 std::size_t threads = 0, const std::function<void(std::size_t)>& done = nullptr);

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_PARALLEL_FOR_H
