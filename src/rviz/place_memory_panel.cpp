#include "rviz/place_memory_panel.h"

#include <ros/exceptions.h>
#include <ros/names.h>

#include <QAbstractItemView>
#include <QItemSelectionModel>
#include <QMessageBox>
#include <QString>
#include <QStringList>
#include <QTreeWidgetItem>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "rviz/verdict_words.h"

namespace place_memory::panel {
namespace {

constexpr int kPollPeriod = 100;  // [ms]
constexpr int kWhole = 100;       // of a progress bar
constexpr char kNodeKey[] = "Node";
constexpr char kProblemColour[] = "color: #b00020";

void fill(QTreeWidget& table, const std::vector<LabelledProbability>& rows) {
  table.clear();
  for (const auto& [label, probability] : rows) {
    table.addTopLevelItem(new QTreeWidgetItem(
        {QString::fromStdString(label), QString::fromStdString(percent(probability))}));
  }
}

/// A style that is set makes Qt lay out the panel anew, also where it is the old one.
void setProblem(QLabel& label, bool is_problem) {
  const QString style = is_problem ? kProblemColour : "";
  if (label.styleSheet() != style) label.setStyleSheet(style);
}

}  // namespace

PlaceMemoryPanel::PlaceMemoryPanel(QWidget* parent)
    : rviz::Panel(parent),
      form_(this),
      places_(new PlaceListModel(this)),
      filtered_(new QSortFilterProxyModel(this)),
      timer_(new QTimer(this)) {
  filtered_->setSourceModel(places_);
  filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  form_.places->setModel(filtered_);
  connectButtons();
  connectList();
  connect(timer_, &QTimer::timeout, this, [this] { poll(); });
  timer_->start(kPollPeriod);
  form_.node->setEditText(QString::fromStdString(backend_.node()));
  poll();
}

void PlaceMemoryPanel::connectButtons() {
  for (const auto& [command, button] : form_.buttons) {
    connect(button, &QPushButton::clicked, this, [this, command = command] { press(command); });
  }
  connect(form_.cancel, &QPushButton::clicked, this, [this] { backend_.cancel(); });
  connect(form_.mode, QOverload<int>::of(&QComboBox::activated), this,
          [this] { backend_.setMode(form_.mode->currentText().toStdString()); });
  connect(form_.label, &QLineEdit::returnPressed, form_.buttons.at(Command::kLearn),
          &QPushButton::click);
  connect(form_.node, QOverload<int>::of(&QComboBox::activated), this,
          [this] { chooseNode(form_.node->currentText()); });
  connect(form_.node->lineEdit(), &QLineEdit::returnPressed, this,
          [this] { chooseNode(form_.node->currentText()); });
}

void PlaceMemoryPanel::connectList() {
  places_->setOnRename([this](const std::string& label, const std::string& new_label) {
    backend_.rename(label, new_label);
  });
  connect(form_.filter, &QLineEdit::textChanged, filtered_,
          &QSortFilterProxyModel::setFilterFixedString);
  connect(form_.places->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this] { showCommands(); });
}

void PlaceMemoryPanel::chooseNode(const QString& name) {
  std::string node;
  try {
    node = ros::names::resolve("/" + name.trimmed().toStdString());
  } catch (const ros::InvalidNameException& error) {
    form_.presence->setText(error.what());
    return;
  }
  if (node == backend_.node()) return;
  backend_.choose(node);
  form_.node->setEditText(QString::fromStdString(node));
  Q_EMIT configChanged();
  poll();
}

void PlaceMemoryPanel::press(Command command) {
  const std::string place = chosenPlace().value_or("");
  switch (command) {
    case Command::kScan:
      backend_.scan();
      break;
    case Command::kLearn:
      backend_.learn(form_.label->text().toStdString());
      form_.label->clear();
      break;
    case Command::kRecognize:
      backend_.recognize();
      break;
    case Command::kRelocalize:
      backend_.relocalize();
      break;
    case Command::kGoTo:
      backend_.goTo(place);
      break;
    case Command::kExplore:
      backend_.explore();
      break;
    case Command::kUndo:
      backend_.undo();
      break;
    case Command::kSave:
      backend_.save(form_.file->text().toStdString());
      break;
    case Command::kLoad:
      backend_.load(form_.file->text().toStdString());
      break;
    case Command::kRename:
      form_.places->edit(form_.places->currentIndex());
      break;
    case Command::kRemove:
      askToRemove(place);
      break;
    case Command::kSetMode:
      break;  // has no button
  }
  poll();
}

void PlaceMemoryPanel::askToRemove(const std::string& label) {
  // Not exec(), which would hold up whoever pressed the button.
  auto* box = new QMessageBox(
      QMessageBox::Question, "Remove a place",
      "Remove the place \"" + QString::fromStdString(label) + "\" and its links from the map?",
      QMessageBox::Yes | QMessageBox::No, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [this, label](int answer) {
    if (answer == QMessageBox::Yes) backend_.remove(label);
  });
  box->open();
}

std::optional<std::string> PlaceMemoryPanel::chosenPlace() const {
  const QModelIndex index = form_.places->currentIndex();
  if (!index.isValid()) return std::nullopt;
  return index.data(Qt::EditRole).toString().toStdString();
}

void PlaceMemoryPanel::poll() {
  const std::optional<PanelView> news = backend_.poll();
  if (news) show(*news);
}

void PlaceMemoryPanel::show(const PanelView& view) {
  const PanelView before = std::exchange(view_, view);
  showNodes(view);
  showPlaces(view);
  showCommands();
  showProgress(view);
  showWhere(view);
  if (view.matches != before.matches) fill(*form_.matches, view.matches);
  if (view.belief != before.belief) fill(*form_.belief, view.belief);
  followChoice(view.chosen);
}

void PlaceMemoryPanel::showNodes(const PanelView& view) {
  QStringList nodes;
  for (const std::string& node : view.presence.nodes) nodes.append(QString::fromStdString(node));
  QStringList shown;
  for (int i = 0; i < form_.node->count(); ++i) shown.append(form_.node->itemText(i));
  if (nodes != shown) {
    const QString typed = form_.node->currentText();
    form_.node->clear();
    form_.node->addItems(nodes);
    form_.node->setEditText(typed);
  }
  const bool is_there = view.presence.kind == Presence::Kind::kThere;
  form_.presence->setText(QString::fromStdString(presenceInWords(view)));
  setProblem(*form_.presence, !is_there);
}

void PlaceMemoryPanel::showCommands() {
  const bool place_is_chosen = chosenPlace().has_value();
  for (const auto& [command, button] : form_.buttons) {
    const std::string reason = whyNot(view_, command, place_is_chosen);
    button->setEnabled(reason.empty());
    button->setToolTip(QString::fromStdString(reason));
  }
  const std::string reason = whyNot(view_, Command::kSetMode, place_is_chosen);
  form_.mode->setEnabled(reason.empty());
  form_.mode->setToolTip(QString::fromStdString(reason));
  const int mode = form_.mode->findText(QString::fromStdString(view_.mode));
  if (!form_.mode->view()->isVisible()) form_.mode->setCurrentIndex(mode);
  form_.cancel->setEnabled(!view_.goals.empty());
}

void PlaceMemoryPanel::showProgress(const PanelView& view) {
  if (!view.goals.empty()) {
    const auto& [action, goal] = *view.goals.begin();
    form_.progress->setRange(0, goal.fraction ? kWhole : 0);  // of no range: busy
    form_.progress->setValue(static_cast<int>(std::lround(kWhole * goal.fraction.value_or(0.0))));
    form_.progress->setFormat(QString::fromStdString(action) + (goal.fraction ? " %p %" : ""));
  } else {
    const bool is_waiting = !view.calls.empty();
    form_.progress->setRange(0, is_waiting ? 0 : kWhole);
    form_.progress->setValue(0);
    form_.progress->setFormat(
        is_waiting ? "waiting for ~" + QString::fromStdString(*view.calls.begin()) : "");
  }
  const bool is_running = !view.goals.empty() && !view.goals.begin()->second.message.empty();
  form_.note->setText(
      QString::fromStdString(is_running ? view.goals.begin()->second.message : view.note.text));
  setProblem(*form_.note, !is_running && view.note.is_problem);
}

void PlaceMemoryPanel::showWhere(const PanelView& view) {
  form_.verdict->setText(QString::fromStdString(view.verdict));
  form_.lost->setText(QString::fromStdString(
      view.lost ? "Lost: " + percent(*view.lost) +
                      ". At none of the places: " + percent(view.off_map.value_or(0.0)) + "."
                : ""));
  form_.belief->setVisible(view.lost.has_value());
  form_.lost->setVisible(view.lost.has_value());
}

void PlaceMemoryPanel::showPlaces(const PanelView& view) {
  // A list that is made anew would close the editor under the person who renames a place.
  if (form_.places->viewport()->findChild<QLineEdit*>() != nullptr) return;
  const QVariant chosen = form_.places->currentIndex().data(PlaceListModel::kIdRole);
  if (!places_->setRows(view.places) || !chosen.isValid()) return;
  choosePlace(chosen);
}

void PlaceMemoryPanel::followChoice(const ChosenPlace& chosen) {
  if (chosen.count == choices_) return;
  choices_ = chosen.count;
  form_.filter->clear();
  choosePlace(QVariant::fromValue<qlonglong>(chosen.id));
  if (chosen.is_to_be_renamed) form_.buttons.at(Command::kRename)->click();
}

void PlaceMemoryPanel::choosePlace(const QVariant& id) {
  const QModelIndexList found =
      filtered_->match(filtered_->index(0, 0), PlaceListModel::kIdRole, id, 1, Qt::MatchExactly);
  if (!found.empty()) form_.places->setCurrentIndex(found.front());
}

void PlaceMemoryPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString(kNodeKey, &node)) chooseNode(node);
}

void PlaceMemoryPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kNodeKey, QString::fromStdString(backend_.node()));
}

}  // namespace place_memory::panel

PLUGINLIB_EXPORT_CLASS(place_memory::panel::PlaceMemoryPanel, rviz::Panel)
