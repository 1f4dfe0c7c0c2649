#include "core/store/store_journal.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "core/store/file_header.h"
#include "place_memory/core/place.h"

namespace place_memory::core {
namespace {

// https://www.sqlite.org/fileformat2.html: section 3 of journals, 1.6 and 2 of pages and rows.

using Bytes = std::vector<unsigned char>;

constexpr std::array<unsigned char, 8> kMagic{0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
constexpr std::size_t kJournalHead = 28;
constexpr std::uint32_t kNotCounted = 0xffffffff;
constexpr std::size_t kNumber = 4;  // bytes
// Of the table `store`, which is the first one to be made, and has one row.
constexpr std::uint32_t kPageOfStore = 2;
constexpr unsigned char kLeaf = 0x0d;
constexpr std::size_t kCellPointer = 8;

Bytes read(std::ifstream& file, std::uint64_t offset, std::size_t size) {
  Bytes bytes(size);
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// Takes numbers out of bytes, the most significant byte of each first.
class Taker {
 public:
  Taker(const Bytes& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::uint64_t fixed(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8U | next();
    return value;
  }
  std::uint64_t variable() {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) {
      const unsigned char byte = next();
      value = value << 7U | (byte & 0x7fU);
      if ((byte & 0x80U) == 0) return value;
    }
    return value << 8U | next();
  }
  void skip(std::uint64_t size) { at_ += static_cast<std::size_t>(std::min(size, kFar)); }
  std::size_t at() const { return at_; }
  bool good() const { return good_; }

 private:
  static constexpr std::uint64_t kFar = 1U << 20U;

  unsigned char next() {
    good_ = good_ && at_ < bytes_.size();
    return good_ ? bytes_[at_++] : 0;
  }

  const Bytes& bytes_;
  std::size_t at_;
  bool good_ = true;
};

/// What the row of `store` begins with.
struct Head {
  PlaceIdentity identity{};
  std::uint64_t version = 0;
};

std::uint64_t sizeOfValue(std::uint64_t type) {
  constexpr std::array<std::uint64_t, 12> kSizes{0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0};
  return type < kSizes.size() ? kSizes[type] : (type - kSizes.size()) / 2;
}

std::uint64_t valueOf(std::uint64_t type, Taker& values) {
  if (type == 8 || type == 9) return type - 8;
  return values.fixed(static_cast<std::size_t>(sizeOfValue(type)));
}

/// Nothing where the page is not that of the table `store`.
std::optional<Head> headOn(const Bytes& page) {
  if (page.empty() || page[0] != kLeaf) return std::nullopt;
  Taker pointer(page, kCellPointer);
  Taker cell(page, static_cast<std::size_t>(pointer.fixed(2)));
  cell.variable();  // size of the row
  if (cell.variable() != 1) return std::nullopt;
  Taker values(page, cell.at());
  values.skip(cell.variable());
  std::array<std::uint64_t, 6> types{};  // id, identity, cell_size, next_place, _session, version
  for (std::uint64_t& type : types) type = cell.variable();
  Head head;
  constexpr std::uint64_t kIdentityType = 12 + 2 * std::tuple_size<PlaceIdentity>::value;
  if (types[1] != kIdentityType || types[5] == 0 || types[5] > 9) return std::nullopt;
  for (std::uint8_t& byte : head.identity) byte = static_cast<std::uint8_t>(values.fixed(1));
  for (std::size_t i = 2; i < 5; ++i) values.skip(sizeOfValue(types[i]));
  head.version = valueOf(types[5], values);
  return cell.good() && values.good() ? std::optional<Head>(head) : std::nullopt;
}

/// A journal that SQLite would roll back.
struct Journal {
  std::uint32_t pages_of_file = 0;  ///< before the change
  std::uint64_t page_size = 0;
  bool is_empty = false;  ///< it was cut off before anything was written to the file
  Bytes page_of_store;    ///< before the change; empty: not in it
};

std::optional<Journal> readJournal(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const Bytes begin = read(file, 0, kJournalHead);
  if (begin.size() < kJournalHead || !std::equal(kMagic.begin(), kMagic.end(), begin.begin())) {
    return std::nullopt;
  }
  Taker numbers(begin, kMagic.size());
  const std::uint64_t rows = numbers.fixed(kNumber);
  numbers.skip(kNumber);  // by which its checksums are made
  Journal journal;
  journal.pages_of_file = static_cast<std::uint32_t>(numbers.fixed(kNumber));
  const std::uint64_t sector = numbers.fixed(kNumber);
  journal.page_size = numbers.fixed(kNumber);
  journal.is_empty = rows == 0;
  const std::size_t page_size =
      static_cast<std::size_t>(std::min<std::uint64_t>(journal.page_size, std::uint64_t{1} << 16U));
  std::uint64_t at = sector;
  for (std::uint64_t row = 0; row < rows; ++row, at += page_size + 2 * kNumber) {
    const Bytes number = read(file, at, kNumber);
    if (number.size() < kNumber) break;
    if (Taker(number, 0).fixed(kNumber) != kPageOfStore) continue;
    journal.page_of_store = read(file, at + kNumber, page_size);
    break;
  }
  journal.is_empty = journal.is_empty && rows != kNotCounted;
  return journal;
}

}  // namespace

std::string journalOf(const std::string& path) { return path + "-journal"; }

bool isJournalOfAnotherFile(const std::string& path) {
  const std::optional<Journal> journal = readJournal(journalOf(path));
  if (!journal) return false;
  FileHeader header;
  if (!header.read(path)) return false;
  if (header.pageSize() == 0 || journal->page_size != header.pageSize()) return true;
  std::error_code error;
  const std::uint64_t pages = std::filesystem::file_size(path, error) / header.pageSize();
  if (journal->is_empty) return !error && pages != journal->pages_of_file;
  std::ifstream file(path, std::ios::binary);
  const Bytes now =
      read(file, (kPageOfStore - 1) * std::uint64_t{header.pageSize()}, header.pageSize());
  if (now == journal->page_of_store) return false;
  const std::optional<Head> after = headOn(now);
  const std::optional<Head> before = headOn(journal->page_of_store);
  // Without either nothing is known: power that fails may leave half of a page.
  if (!before || !after) return false;
  const bool is_next = after->version == before->version || after->version == before->version + 1;
  return after->identity != before->identity || !is_next;
}

}  // namespace place_memory::core
