#include "rviz/panel_form.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QSize>
#include <QSizePolicy>
#include <QString>
#include <QVBoxLayout>

namespace place_memory::panel {
namespace {

constexpr int kTableRows = 5;
constexpr int kListRows = 6;       // at the least
constexpr int kLeastHeight = 380;  // beside rviz's displays on a screen of 720 lines [pixels]

/// Wants room for all that is in it; Qt's own wants no more than some twenty lines.
class FormArea : public QScrollArea {
 public:
  QSize sizeHint() const override { return widget()->sizeHint(); }
};

template <class Widget>
Widget* named(Widget* widget, const char* name) {
  widget->setObjectName(name);
  return widget;
}

QLineEdit* makeEdit(const char* name, const char* hint) {
  auto* edit = named(new QLineEdit, name);
  edit->setPlaceholderText(hint);
  return edit;
}

/// A sentence of any length, which does not make the panel wider.
QLabel* makeSentence(const char* name) {
  auto* label = named(new QLabel, name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  return label;
}

QTreeWidget* makeTable(const char* name, const char* column) {
  auto* table = named(new QTreeWidget, name);
  table->setHeaderLabels({column, "probability"});
  table->setRootIsDecorated(false);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setUniformRowHeights(true);
  table->header()->setStretchLastSection(false);
  table->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  const int row = table->fontMetrics().height() + 4;
  table->setFixedHeight(row * (kTableRows + 1) + 8);
  return table;
}

QPushButton* makeButton(PanelForm& form, Command command, const char* name, const char* text) {
  auto* button = named(new QPushButton(text), name);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  form.buttons[command] = button;
  return button;
}

QLayout* makeNodeRows(PanelForm& form) {
  form.node = named(new QComboBox, "node");
  form.node->setEditable(true);
  form.node->setInsertPolicy(QComboBox::NoInsert);
  form.node->setToolTip("full name of the place memory's node");
  form.presence = makeSentence("presence");
  form.mode = named(new QComboBox, "mode");
  form.mode->addItems({"off", "map", "localize"});
  auto* rows = new QGridLayout;
  rows->addWidget(new QLabel("Node"), 0, 0);
  rows->addWidget(form.node, 0, 1);
  rows->addWidget(form.presence, 1, 1);
  rows->addWidget(new QLabel("Mode"), 2, 0);
  rows->addWidget(form.mode, 2, 1);
  rows->setColumnStretch(1, 1);
  return rows;
}

QLayout* makeCommands(PanelForm& form) {
  form.label = makeEdit("label", "label; empty: one is made up");
  form.file = makeEdit("file", "file of the store, e.g. office.db");
  auto* rows = new QGridLayout;
  rows->addWidget(makeButton(form, Command::kScan, "scan", "Scan"), 0, 0);
  rows->addWidget(makeButton(form, Command::kRecognize, "recognize", "Recognize"), 0, 1);
  rows->addWidget(makeButton(form, Command::kRelocalize, "relocalize", "Relocalize"), 0, 2);
  rows->addWidget(makeButton(form, Command::kLearn, "learn", "Learn"), 1, 0);
  rows->addWidget(form.label, 1, 1, 1, 2);
  rows->addWidget(makeButton(form, Command::kGoTo, "go_to", "Go to"), 2, 0);
  rows->addWidget(makeButton(form, Command::kExplore, "explore", "Explore"), 2, 1);
  rows->addWidget(makeButton(form, Command::kUndo, "undo", "Undo"), 2, 2);
  rows->addWidget(makeButton(form, Command::kSave, "save", "Save"), 3, 0);
  rows->addWidget(makeButton(form, Command::kLoad, "load", "Load"), 3, 1);
  rows->addWidget(form.file, 3, 2);
  for (int column = 0; column < 3; ++column) rows->setColumnStretch(column, 1);
  return rows;
}

QLayout* makeProgress(PanelForm& form) {
  form.progress = named(new QProgressBar, "progress");
  form.progress->setTextVisible(true);
  form.progress->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  form.cancel = named(new QPushButton("Cancel"), "cancel");
  form.note = makeSentence("note");
  auto* bar = new QHBoxLayout;
  bar->addWidget(form.progress, 1);
  bar->addWidget(form.cancel);
  auto* rows = new QVBoxLayout;
  rows->addLayout(bar);
  rows->addWidget(form.note);
  return rows;
}

QWidget* makeWhere(PanelForm& form) {
  form.verdict = makeSentence("verdict");
  form.matches = makeTable("matches", "match of the newest scan");
  form.lost = makeSentence("lost");
  form.belief = makeTable("belief", "belief");
  auto* box = new QGroupBox("Where the robot is");
  auto* rows = new QVBoxLayout(box);
  for (QWidget* row : {static_cast<QWidget*>(form.verdict), static_cast<QWidget*>(form.matches),
                       static_cast<QWidget*>(form.lost), static_cast<QWidget*>(form.belief)}) {
    rows->addWidget(row);
  }
  return box;
}

QWidget* makePlaces(PanelForm& form) {
  form.filter = makeEdit("filter", "part of a label");
  form.filter->setClearButtonEnabled(true);
  form.places = named(new QListView, "places");
  form.places->setUniformItemSizes(true);
  form.places->setEditTriggers(QAbstractItemView::NoEditTriggers);
  form.places->setMinimumHeight(kListRows * form.places->fontMetrics().height());
  auto* box = new QGroupBox("Places");
  auto* rows = new QGridLayout(box);
  rows->addWidget(form.filter, 0, 0, 1, 2);
  rows->addWidget(form.places, 1, 0, 1, 2);
  rows->addWidget(makeButton(form, Command::kRename, "rename", "Rename"), 2, 0);
  rows->addWidget(makeButton(form, Command::kRemove, "remove", "Remove"), 2, 1);
  rows->setRowStretch(1, 1);
  return box;
}

}  // namespace

PanelForm::PanelForm(QWidget* panel) {
  // On a small screen it is scrolled, and rviz's window need not grow.
  auto* area = new FormArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumHeight(kLeastHeight);
  auto* content = new QWidget;
  area->setWidget(content);
  auto* frame = new QVBoxLayout(panel);
  frame->setContentsMargins(0, 0, 0, 0);
  frame->addWidget(area);

  auto* rows = new QVBoxLayout(content);
  rows->addLayout(makeNodeRows(*this));
  rows->addLayout(makeCommands(*this));
  rows->addLayout(makeProgress(*this));
  rows->addWidget(makeWhere(*this));
  rows->addWidget(makePlaces(*this), 1);
}

}  // namespace place_memory::panel
