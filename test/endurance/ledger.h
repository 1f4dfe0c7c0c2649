#ifndef PLACE_MEMORY_TEST_ENDURANCE_LEDGER_H
#define PLACE_MEMORY_TEST_ENDURANCE_LEDGER_H

#include <map>
#include <set>
#include <string>
#include <vector>

#include "endurance/change_log.h"

namespace place_memory {

/// Follows what processes said that were killed one after the other, and knows by that what the
/// next one has to find: the map as it was told last, or the one after the single change that may
/// have been kept and was not told any more.
class Ledger {
 public:
  void add(const Said& said);

  /// Changes that a client was told are done.
  int acknowledged() const { return acknowledged_; }
  /// How often a memory was opened.
  int openings() const { return openings_; }
  /// How often it had kept a change that it had not come to tell.
  int untold() const { return untold_; }
  const MapRecord& map() const { return map_; }
  /// Whatever must not be, in sentences.
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  void open(const MapRecord& found);
  void acknowledge(const Said& said);
  bool isOneMore(const MapRecord& found) const;
  bool explains(const Said& asked, const MapRecord& found) const;
  bool has(const std::string& label) const;

  MapRecord map_;
  std::map<std::uint32_t, Said> asked_;            ///< by client: what it waits for
  std::vector<std::multiset<std::string>> saved_;  ///< labels that a saved copy may have
  std::set<std::uint32_t> cleared_;  ///< clients who wait while somebody clears the map
  int acknowledged_ = 0;
  int openings_ = 0;
  int untold_ = 0;
  std::vector<std::string> problems_;
};

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_LEDGER_H
