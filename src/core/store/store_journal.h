#ifndef PLACE_MEMORY_CORE_STORE_STORE_JOURNAL_H
#define PLACE_MEMORY_CORE_STORE_STORE_JOURNAL_H

#include <string>

namespace place_memory::core {

/// Where SQLite keeps what a change that is under way replaces.
std::string journalOf(const std::string& path);

/// Whether the journal beside a store cannot be of the change that was cut off in this file: the
/// file is another store, or the same one as it was at another time, as with a backup that was put
/// in its place. SQLite would write the journal's pages into it all the same. Known of stores from
/// format 3 on.
bool isJournalOfAnotherFile(const std::string& path);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_JOURNAL_H
