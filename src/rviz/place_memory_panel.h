#ifndef PLACE_MEMORY_RVIZ_PLACE_MEMORY_PANEL_H
#define PLACE_MEMORY_RVIZ_PLACE_MEMORY_PANEL_H

#include <rviz/config.h>
#include <rviz/panel.h>

#include <QModelIndex>
#include <QSortFilterProxyModel>
#include <QTimer>
#include <QVariant>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <string>

#include "rviz/panel_backend.h"
#include "rviz/panel_form.h"
#include "rviz/place_list_model.h"

namespace place_memory::panel {

/// The place memory in rviz: what a person asks it for, and what it knows. The paper's graphical
/// interface.
class PlaceMemoryPanel : public rviz::Panel {
 public:
  explicit PlaceMemoryPanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void connectButtons();
  void connectList();
  void chooseNode(const QString& name);
  void press(Command command);
  void askToRemove(const std::string& label);
  std::optional<std::string> chosenPlace() const;
  void choosePlace(const QVariant& id);

  void poll();
  void show(const PanelView& view);
  void showNodes(const PanelView& view);
  void showCommands();
  void showProgress(const PanelView& view);
  void showWhere(const PanelView& view);
  void showPlaces(const PanelView& view);
  void followChoice(const ChosenPlace& chosen);

  PanelBackend backend_;
  PanelForm form_;
  PlaceListModel* places_;
  QSortFilterProxyModel* filtered_;
  QTimer* timer_;
  PanelView view_;             // that is shown
  std::uint64_t choices_ = 0;  // that were followed
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PLACE_MEMORY_PANEL_H
