#include "core/store/place_store.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "core/store/place_ids.h"
#include "core/store/sqlite.h"
#include "core/store/store_copy.h"
#include "core/store/store_file.h"
#include "core/store/store_head.h"
#include "core/store/store_migration.h"
#include "core/store/store_reader.h"
#include "core/store/store_scans.h"
#include "core/store/store_schema.h"
#include "core/store/store_writer.h"

namespace place_memory::core {

class PlaceStore::Impl {
 public:
  Impl(const std::string& path, double cell_size, StoreOpening opening)
      : path_(storePath(path)), cell_size_(cell_size), opening_(std::move(opening)) {
    open();
  }

  PlaceMap map() {
    StoreReader::Map rows = opened_ ? std::move(*opened_) : reader().readMap();
    opened_.reset();
    try {
      return {std::move(rows.places), rows.links, head_.version, head_.stamp};
    } catch (const std::invalid_argument& error) {
      throwStoreError(path_, std::string("is damaged: ") + error.what());
    }
  }

  KeptMap scans() {
    reader();
    StoreTotals found;
    KeptMap scans = readScans(*database_, &head_, damages_, found);
    scans.next_place = head_.next_place;
    for (ScanNode& node : scans.nodes) {
      if (!std::binary_search(ids_.begin(), ids_.end(), node.place)) node.place = kNoPlace;
    }
    return scans;
  }

  void commit(const MapChange& change, const KeptMap* scans, const HistoryEdit* history) {
    resume();
    StoreHead head = head_;
    head.version = change.version;
    head.stamp = change.stamp;
    try {
      SqliteTransaction transaction(*database_);
      knowLabels();
      StoreWriter writer(*database_, head, labels_);
      for (const MapEdit& edit : change.edits) std::visit(writer, edit);
      writer.finish();
      if (scans != nullptr) writeScans(*database_, *scans, head);
      if (history != nullptr) writeHistory(*database_, *history, head);
      writeHead(*database_, head);
      transaction.commit();
    } catch (const SqliteError& error) {
      are_labels_known_ = false;
      if (error.isOfDisk()) why_read_only_ = error.what();
      throw;
    } catch (...) {
      are_labels_known_ = false;
      throw;
    }
    head_ = head;
    why_read_only_.clear();
    opened_.reset();
    follow(change, ids_);
  }

  StoreReader& reader() {
    if (!reader_) throw StoreError(why_read_only_);
    return *reader_;
  }

  void requirePlace(PlaceId id) const {
    if (!std::binary_search(ids_.begin(), ids_.end(), id)) {
      throwStoreError(path_, "has no place " + std::to_string(id));
    }
  }

  SqliteDatabase& database() {
    reader();
    return *database_;
  }

  const std::string& path() const { return path_; }
  double cellSize() const { return cell_size_; }
  const std::string& whyReadOnly() const { return why_read_only_; }
  const Damages& damages() const { return damages_; }
  const StoreHead& head() const { return head_; }
  const std::vector<PlaceId>& ids() const { return ids_; }
  const StoreProgress& progress() const { return opening_.progress; }

 private:
  void open() {
    StoreFile file;
    if (path_.empty()) {
      file.database = std::make_unique<SqliteDatabase>(":memory:", true);
      createSchema(*file.database);
      StoreHead head;
      head.identity = makeIdentity();
      head.cell_size = cell_size_;
      writeHead(*file.database, head);
    } else {
      file = openStoreFile(path_, cell_size_, opening_);
      if (file.format < kStoreFormat) {
        file = migrateStore(std::move(file), path_, cell_size_, opening_, held_);
      }
    }
    read(*file.database, file.checked);
    database_ = std::move(file.database);
    why_read_only_ = file.why_read_only;
  }

  void read(SqliteDatabase& database, bool check_all) {
    const std::optional<StoreHead> head = readHead(database);
    if (head) {
      head_ = *head;
      requireCellSize(path_, head_.cell_size, cell_size_);
    } else {
      damages_.add("the store's own row is damaged: the numbers of places are made anew from them");
    }
    reader_ =
        std::make_unique<StoreReader>(database, cell_size_, head ? &head_ : nullptr, damages_);
    opened_ = reader_->readMap();
    ids_ = idsOf(opened_->places);
    labels_.clear();
    for (const Place& place : opened_->places) labels_.add(place.label);
    are_labels_known_ = true;
    StoreTotals found;  // of what belongs to the drives, and of the history
    if (check_all || !head) {
      reader_->forEachPlanes(ids_, nullptr, [](PlaceId, const CellPlanes&) {});
      reader_->forEachGrid(ids_, [](PlaceId, const EvidenceGrid&) {});
      reader_->checkReadings();
      reader_->traversals();
      readScans(database, head ? &head_ : nullptr, damages_, found);
      checkHistory(database, head ? &head_ : nullptr, damages_, found);
    }
    if (!head) makeHead(found);
  }

  // Where the store's own row says nothing any more.
  void makeHead(const StoreTotals& of_scans) {
    head_ = StoreHead();
    head_.identity = makeIdentity();
    head_.cell_size = cell_size_;
    head_.totals = reader_->found();
    for (const StoreTable table :
         {StoreTable::kNode, StoreTable::kTie, StoreTable::kWheels, StoreTable::kHistory}) {
      head_.totals.of(table) = of_scans.of(table);
    }
    head_.next_place = reader_->highestId() + 1;
    for (const Place& place : opened_->places) {
      head_.next_session = std::max(head_.next_session, place.session + 1);
      head_.stamp = std::max(head_.stamp, place.learned);
    }
  }

  // What could not be written when it was opened is opened anew, unless that is bound to fail too.
  void resume() {
    if (is_changed_) throw StoreError(why_read_only_);
    const bool is_writable = database_ && !held_ && !database_->isReadOnly();
    if (is_writable) return;
    const std::string folder = std::filesystem::path(path_).parent_path().string();
    if (access(path_.c_str(), W_OK) != 0 || access(folder.c_str(), W_OK) != 0) {
      throw StoreError(why_read_only_);
    }
    const StoreHead before = head_;
    reader_.reset();
    database_.reset();
    held_.reset();
    try {
      open();
    } catch (const StoreError& error) {
      reader_.reset();
      why_read_only_ = error.what();
      throw;
    }
    is_changed_ = !head_.matches(before);
    if (is_changed_) {
      why_read_only_ = "place store " + path_ +
                       ": another program has changed it since it was read: start the node again";
    }
    if (!why_read_only_.empty()) throw StoreError(why_read_only_);
  }

  // After a change that failed half-way.
  void knowLabels() {
    if (are_labels_known_) return;
    labels_.clear();
    scanTable(
        *database_, {"place", "id", "id, label"},
        [this](const SqliteStatement& row) { labels_.add(row.text(1)); },
        [](std::int64_t /*unreadable*/) {});
    are_labels_known_ = true;
  }

  const std::string path_;
  const double cell_size_;
  const StoreOpening opening_;
  std::unique_ptr<SqliteDatabase> database_;
  std::unique_ptr<SqliteDatabase> held_;  ///< file in an old format, of which database_ is a copy
  std::string why_read_only_;
  bool is_changed_ = false;  ///< by another program
  StoreHead head_;
  Damages damages_;
  std::unique_ptr<StoreReader> reader_;
  std::optional<StoreReader::Map> opened_;  ///< until it is asked for or changes
  std::vector<PlaceId> ids_;                ///< of all places, rising
  LabelHashes labels_;
  bool are_labels_known_ = false;
};

PlaceStore::PlaceStore(const std::string& path, double cell_size, const StoreOpening& opening)
    : impl_(std::make_unique<Impl>(path, cell_size, opening)) {}
PlaceStore::~PlaceStore() = default;
PlaceStore::PlaceStore(PlaceStore&&) noexcept = default;
PlaceStore& PlaceStore::operator=(PlaceStore&&) noexcept = default;

const std::string& PlaceStore::path() const { return impl_->path(); }
const std::string& PlaceStore::whyReadOnly() const { return impl_->whyReadOnly(); }
const std::vector<std::string>& PlaceStore::setAside() const {
  return impl_->damages().sentences();
}
const PlaceIdentity& PlaceStore::identity() const { return impl_->head().identity; }
PlaceMap PlaceStore::map() const { return impl_->map(); }
PlaceId PlaceStore::nextId() const { return impl_->head().next_place; }
SessionId PlaceStore::nextSession() const { return impl_->head().next_session; }

EvidenceGrid PlaceStore::grid(PlaceId id) const {
  impl_->requirePlace(id);
  const std::optional<EvidenceGrid> grid = impl_->reader().grid(id);
  if (!grid) {
    throwStoreError(path(), "is damaged: the grid of place " + std::to_string(id) +
                                " is not as it was written");
  }
  return *grid;
}

std::vector<SonarReading> PlaceStore::readings(PlaceId id) const {
  impl_->requirePlace(id);
  std::optional<std::vector<SonarReading>> readings = impl_->reader().readings(id);
  if (!readings) {
    throwStoreError(path(), "is damaged: the readings of place " + std::to_string(id) +
                                " are not as they were written");
  }
  return std::move(*readings);
}

void PlaceStore::forEachGrid(const std::function<void(PlaceId, const EvidenceGrid&)>& call) const {
  impl_->reader().forEachGrid(impl_->ids(), call);
}

void PlaceStore::forEachPlanes(const std::function<void(PlaceId, const CellPlanes&)>& call) const {
  impl_->reader().forEachPlanes(impl_->ids(), impl_->progress(), call);
}

KeptMap PlaceStore::scans() const { return impl_->scans(); }
std::vector<Traversal> PlaceStore::traversals() const { return impl_->reader().traversals(); }

void PlaceStore::commit(const MapChange& change) { impl_->commit(change, nullptr, nullptr); }
void PlaceStore::commit(const MapChange& change, const KeptMap& scans) {
  impl_->commit(change, &scans, nullptr);
}

void PlaceStore::commit(const MapChange& change, const HistoryEdit& history) {
  impl_->commit(change, nullptr, &history);
}

std::vector<PastChange> PlaceStore::history(std::size_t most) const {
  return readHistory(impl_->database(), most);
}

std::optional<std::vector<MapEdit>> PlaceStore::inverse(std::uint64_t version) const {
  return readInverse(impl_->database(), version, impl_->cellSize());
}

void PlaceStore::saveAs(const std::string& path) const {
  saveCopy(impl_->database(), storePath(path));
}

}  // namespace place_memory::core
