#ifndef PLACE_MEMORY_TEST_LAYERS_TABLE_H
#define PLACE_MEMORY_TEST_LAYERS_TABLE_H

#include <optional>
#include <string>
#include <vector>

namespace place_memory::layers {

/// The part of the package that a source file belongs to, e.g. `core/match`, `config`, `sim/scene`;
/// nothing where it is in no folder of the table. `file` lies below the package's root, e.g.
/// `src/core/match/lattice.h`. A public header belongs to the part of its content.
std::optional<std::string> partOfFile(const std::string& file);

/// The part that a header belongs to by the name under which it is included; for headers of others
/// the library's, e.g. `std`, `boost`, and `ros` for all that is not known to be of another.
std::string partOfHeader(const std::string& header);

/// Whether a file of `from` may include a header of `to`.
bool mayInclude(const std::string& from, const std::string& to);

/// What of `headers`, included by `file`, runs against the table: a sentence each.
std::vector<std::string> violations(const std::string& file,
                                    const std::vector<std::string>& headers);

}  // namespace place_memory::layers

#endif  // PLACE_MEMORY_TEST_LAYERS_TABLE_H
