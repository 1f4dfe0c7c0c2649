#ifndef PLACE_MEMORY_TEST_ENDURANCE_POWER_CUT_H
#define PLACE_MEMORY_TEST_ENDURANCE_POWER_CUT_H

namespace place_memory {

/// With which a process ends whose power fails.
constexpr int kPowerFailed = 77;

/// From now on every database of this process lies on a disk whose power fails when SQLite is about
/// to do something to it for the `operation`-th time (counted from 1: a write, a truncation, a
/// synchronization, a file made or deleted). What was not synchronized by then is there or not,
/// each sector of 512 bytes, each name and each file's length by chance; the process ends with
/// kPowerFailed. What a file held when it was opened first was there already.
void letPowerFail(int operation, unsigned seed);

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_POWER_CUT_H
