#ifndef PLACE_MEMORY_RVIZ_PANEL_FORM_H
#define PLACE_MEMORY_RVIZ_PANEL_FORM_H

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>
#include <map>

#include "rviz/command.h"

namespace place_memory::panel {

/// The panel's widgets, laid out, which do nothing yet. Their parents own them. Each has its name
/// as object name, a button that of what it asks for, e.g. "learn".
struct PanelForm {
  explicit PanelForm(QWidget* panel);

  QComboBox* node = nullptr;
  QLabel* presence = nullptr;
  QComboBox* mode = nullptr;
  std::map<Command, QPushButton*> buttons;
  QLineEdit* label = nullptr;  ///< of the place that is learned next
  QLineEdit* file = nullptr;   ///< of the store that is saved or loaded
  QProgressBar* progress = nullptr;
  QPushButton* cancel = nullptr;
  QLabel* note = nullptr;
  QLabel* verdict = nullptr;
  QTreeWidget* matches = nullptr;
  QLabel* lost = nullptr;
  QTreeWidget* belief = nullptr;
  QLineEdit* filter = nullptr;
  QListView* places = nullptr;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PANEL_FORM_H
