#ifndef PLACE_MEMORY_CORE_STORE_OPENING_H
#define PLACE_MEMORY_CORE_STORE_OPENING_H

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "place_memory/export.h"

namespace place_memory::core {

/// What is wrong with a store, in a sentence that names its file.
class PLACE_MEMORY_PUBLIC StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Is told in a sentence, now and then, how far a long work has come.
using StoreProgress = std::function<void(const std::string& sentence)>;

struct StoreOpening {
  /// A store that is no larger is read and checked from end to end when it is opened [bytes]: about
  /// 48 000 places in a second. So is one whose last user did not end in good order, as
  /// with power that fails. Of a larger one each row is checked when it is read.
  std::uintmax_t full_check_size = std::uintmax_t{256} << 20U;
  StoreProgress progress;  ///< may be null
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_OPENING_H
