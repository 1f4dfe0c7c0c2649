#include "support/parallel_for.h"

#include <algorithm>
#include <mutex>

#include "support/worker_pool.h"

namespace place_memory::support {

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work,
                 std::size_t threads, const std::function<void(std::size_t)>& done) {
  WorkerPool pool(std::min(threads == 0 ? processorThreads() : threads, count));
  std::mutex mutex;
  std::size_t finished = 0;
  pool.run(count, [&](std::size_t i) {
    work(i);
    if (!done) return;
    const std::lock_guard<std::mutex> lock(mutex);
    done(++finished);
  });
}

}  // namespace place_memory::support
