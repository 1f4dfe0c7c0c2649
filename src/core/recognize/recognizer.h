#ifndef PLACE_MEMORY_CORE_RECOGNIZE_RECOGNIZER_H
#define PLACE_MEMORY_CORE_RECOGNIZE_RECOGNIZER_H

#include <functional>
#include <memory>
#include <optional>

#include "core/index/place_index.h"
#include "core/recognize/place_frame.h"
#include "place_memory/core/recognition.h"
#include "place_memory/core/recognizer_options.h"
#include "place_memory/core/scan.h"

namespace place_memory::support {
class WorkerPool;
}

namespace place_memory::core {

/// Appearance-based place recognition by evidence grids (Yamauchi and Langley, Place Recognition in
/// Dynamic Environments, 1997: the paper).
class Recognizer {
 public:
  /// Throws std::invalid_argument naming the option that is out of range, or with a sentence on the
  /// environment variable PLACE_MEMORY_ISA where it cannot be followed.
  explicit Recognizer(const RecognizerOptions& options);

  /// Ranks every place of the index. A scan that holds no echo is UNKNOWN, and no place probable,
  /// whatever the scores. `heading_window` is how far the compass may be off, in [0, pi]
  /// [rad]; pi stands for any heading. `cancelled`, where given, is polled between blocks of
  /// places; once it returns true the call throws std::runtime_error. Throws std::invalid_argument
  /// where the window is out of range. Thread-safe.
  ///
  /// `frames` is called once, for the places that rank first. Where one of them is gone there is no
  /// answer: the caller asks again with a newer index.
  std::optional<Recognition> recognize(const Scan& scan, const PlaceIndex& places,
                                       const LookUpFrames& frames, double heading_window,
                                       const std::function<bool()>& cancelled = nullptr) const;

 private:
  RecognizerOptions options_;
  std::shared_ptr<support::WorkerPool> pool_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_RECOGNIZER_H
