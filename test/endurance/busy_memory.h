#ifndef PLACE_MEMORY_TEST_ENDURANCE_BUSY_MEMORY_H
#define PLACE_MEMORY_TEST_ENDURANCE_BUSY_MEMORY_H

#include <string>

namespace place_memory {

/// A memory and what its clients do to it.
struct BusyMemory {
  std::string store;
  std::string log;    ///< of ChangeLog
  std::string saved;  ///< a file that is written by saving, in a folder of its own
  unsigned clients = 1;
  unsigned seed = 1;
};

/// Opens the store, and has the clients learn, recognize (places adapt, and sessions join), rename,
/// remove, clear, relax, travel, order links and save, all at once and without an end, which has to
/// come from outside. One who is alone drives to new places, loads, merges and takes back changes,
/// too. Ends by itself where something happens that must not. Everything is said in the log.
[[noreturn]] void keepBusy(const BusyMemory& busy);

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_BUSY_MEMORY_H
