#ifndef PLACE_MEMORY_RVIZ_PLACE_LIST_MODEL_H
#define PLACE_MEMORY_RVIZ_PLACE_LIST_MODEL_H

#include <QAbstractListModel>
#include <functional>
#include <memory>
#include <string>

#include "rviz/place_list.h"

namespace place_memory::panel {

/// Places for a list on the screen, of which only the part in view is looked at.
class PlaceListModel : public QAbstractListModel {
 public:
  static constexpr int kIdRole = Qt::UserRole;

  /// Asked to give a place another label; the list changes once the map has.
  using OnRename = std::function<void(const std::string& label, const std::string& new_label)>;

  explicit PlaceListModel(QObject* parent) : QAbstractListModel(parent) {}

  void setOnRename(const OnRename& on_rename) { on_rename_ = on_rename; }
  /// False where nothing changes.
  bool setRows(const std::shared_ptr<const PlaceRows>& rows);

  int rowCount(const QModelIndex& parent = QModelIndex()) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  const PlaceRow* row(const QModelIndex& index) const;

  std::shared_ptr<const PlaceRows> rows_ = std::make_shared<const PlaceRows>();
  OnRename on_rename_;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PLACE_LIST_MODEL_H
