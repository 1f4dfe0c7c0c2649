#ifndef PLACE_MEMORY_TEST_CORE_STORE_DAMAGE_H
#define PLACE_MEMORY_TEST_CORE_STORE_DAMAGE_H

#include <functional>
#include <ostream>
#include <string>

#include "core/store/store_fixture.h"

namespace place_memory::core {

/// What happened to a good store, and what is said of it.
struct Damage {
  const char* name;
  std::function<void(const std::string& path)> inflict;
  const char* message;
};

inline void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }

inline std::function<void(const std::string&)> sql(const std::string& statements) {
  return [statements](const std::string& path) { runSql(path, statements); };
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_DAMAGE_H
