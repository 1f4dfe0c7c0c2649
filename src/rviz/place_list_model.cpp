#include "rviz/place_list_model.h"

#include <QString>
#include <cstddef>

namespace place_memory::panel {

bool PlaceListModel::setRows(const std::shared_ptr<const PlaceRows>& rows) {
  if (!rows || rows == rows_) return false;
  beginResetModel();
  rows_ = rows;
  endResetModel();
  return true;
}

const PlaceRow* PlaceListModel::row(const QModelIndex& index) const {
  const bool is_there = index.isValid() && index.row() < rowCount();
  return is_there ? &(*rows_)[static_cast<std::size_t>(index.row())] : nullptr;
}

int PlaceListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_->size());
}

QVariant PlaceListModel::data(const QModelIndex& index, int role) const {
  const PlaceRow* place = row(index);
  if (place == nullptr) return QVariant();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return QString::fromStdString(place->label);
    case Qt::ToolTipRole:
      return QString("place %1 at (%2, %3) m, session %4")
          .arg(place->id)
          .arg(place->x, 0, 'f', 2)
          .arg(place->y, 0, 'f', 2)
          .arg(place->session);
    case kIdRole:
      return QVariant::fromValue<qlonglong>(place->id);
    default:
      return QVariant();
  }
}

bool PlaceListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const PlaceRow* place = row(index);
  if (place == nullptr || role != Qt::EditRole || !on_rename_) return false;
  const std::string new_label = value.toString().toStdString();
  if (new_label != place->label) on_rename_(place->label, new_label);
  return false;
}

Qt::ItemFlags PlaceListModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsEditable;
}

}  // namespace place_memory::panel
