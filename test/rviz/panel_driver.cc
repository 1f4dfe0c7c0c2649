// Presses the panel's buttons for a test, without rviz around it: loads the panel as rviz does, and
// obeys the lines that come on its standard input, each with one line on its output.
#include <ros/init.h>
#include <rviz/panel.h>
#include <rviz/yaml_config_reader.h>
#include <rviz/yaml_config_writer.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPixmap>
#include <QProgressBar>
#include <QSocketNotifier>
#include <QString>
#include <QTimer>
#include <QTreeWidget>
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <pluginlib/class_loader.hpp>
#include <stdexcept>
#include <string>

#include "rviz/hold_watch.h"

namespace {

std::string textOf(const QTreeWidget& table) {
  QStringList rows;
  for (int i = 0; i < table.topLevelItemCount(); ++i) {
    const QTreeWidgetItem* row = table.topLevelItem(i);
    rows.append(row->text(0) + " " + row->text(1));
  }
  return rows.join("; ").toStdString();
}

std::string textOf(const QListView& list) {
  QStringList rows;
  for (int i = 0; i < list.model()->rowCount(); ++i) {
    rows.append(list.model()->index(i, 0).data().toString());
  }
  return rows.join("; ").toStdString();
}

class Driver {
 public:
  explicit Driver(rviz::Panel& panel) : panel_(panel) {}

  /// What the line asks for; std::runtime_error where it cannot be done.
  std::string obey(const std::string& line) {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string verb = line.substr(0, space);
    const std::string rest = line.substr(std::min(space + 1, line.size()));
    const auto found = verbs_.find(verb);
    if (found == verbs_.end()) throw std::runtime_error("no such verb: " + verb);
    return found->second(rest);
  }

 private:
  template <class Widget>
  Widget& find(const std::string& name) {
    auto* widget = panel_.findChild<Widget*>(QString::fromStdString(name));
    if (widget == nullptr) throw std::runtime_error("no such widget: " + name);
    return *widget;
  }

  std::string click(const std::string& name) {
    auto& button = find<QAbstractButton>(name);
    if (!button.isEnabled()) throw std::runtime_error("greyed: " + button.toolTip().toStdString());
    button.click();
    return "";
  }

  std::string type(const std::string& name_and_text) {
    const std::size_t space = name_and_text.find(' ');
    find<QLineEdit>(name_and_text.substr(0, space))
        .setText(QString::fromStdString(name_and_text.substr(space + 1)));
    return "";
  }

  std::string node(const std::string& name) {
    auto& box = find<QComboBox>("node");
    box.setEditText(QString::fromStdString(name));
    Q_EMIT box.lineEdit()->returnPressed();
    return "";
  }

  std::string mode(const std::string& name) {
    auto& box = find<QComboBox>("mode");
    if (!box.isEnabled()) throw std::runtime_error("greyed: " + box.toolTip().toStdString());
    const int index = box.findText(QString::fromStdString(name));
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
    return "";
  }

  std::string choose(const std::string& label) {
    auto& list = find<QListView>("places");
    const auto found = list.model()->match(list.model()->index(0, 0), Qt::DisplayRole,
                                           QString::fromStdString(label), 1, Qt::MatchExactly);
    if (found.empty()) throw std::runtime_error("no such place: " + label);
    list.setCurrentIndex(found.front());
    return "";
  }

  /// Types into the editor that is open in the list.
  std::string edit(const std::string& text) {
    auto& list = find<QListView>("places");
    auto* editor = list.viewport()->findChild<QLineEdit*>();
    if (editor == nullptr) throw std::runtime_error("no editor is open");
    editor->setText(QString::fromStdString(text));
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QApplication::sendEvent(editor, &enter);
    return "";
  }

  /// What is being renamed; empty: nothing.
  std::string edits() {
    auto* editor = find<QListView>("places").viewport()->findChild<QLineEdit*>();
    return editor == nullptr ? "" : editor->text().toStdString();
  }

  std::string answerYes(const std::string&) {
    auto* box = panel_.findChild<QMessageBox*>();
    if (box == nullptr) throw std::runtime_error("nothing was asked");
    box->button(QMessageBox::Yes)->click();
    return "";
  }

  /// Why a button is greyed; empty: it is not.
  std::string greyed(const std::string& name) {
    auto& widget = find<QWidget>(name);
    return widget.isEnabled() ? "" : widget.toolTip().toStdString();
  }

  std::string show(const std::string& name) {
    auto* widget = &find<QWidget>(name);
    if (auto* label = qobject_cast<QLabel*>(widget)) return label->text().toStdString();
    if (auto* box = qobject_cast<QComboBox*>(widget)) return box->currentText().toStdString();
    if (auto* table = qobject_cast<QTreeWidget*>(widget)) return textOf(*table);
    if (auto* list = qobject_cast<QListView*>(widget)) return textOf(*list);
    if (auto* bar = qobject_cast<QProgressBar*>(widget)) return bar->text().toStdString();
    throw std::runtime_error("nothing to read in " + name);
  }

  std::string save(const std::string& path) {
    rviz::Config config;
    panel_.save(config);
    rviz::YamlConfigWriter().writeFile(config, QString::fromStdString(path));
    return "";
  }

  std::string load(const std::string& path) {
    rviz::Config config;
    rviz::YamlConfigReader().readFile(config, QString::fromStdString(path));
    panel_.load(config);
    return "";
  }

  std::string grab(const std::string& path) {
    if (!panel_.grab().save(QString::fromStdString(path))) throw std::runtime_error("not written");
    return "";
  }

  using Verb = std::function<std::string(const std::string&)>;

  rviz::Panel& panel_;
  place_memory::panel::HoldWatch watch_;
  const std::map<std::string, Verb> verbs_{
      {"click", [this](const std::string& name) { return click(name); }},
      {"type", [this](const std::string& words) { return type(words); }},
      {"node", [this](const std::string& name) { return node(name); }},
      {"mode", [this](const std::string& name) { return mode(name); }},
      {"choose", [this](const std::string& label) { return choose(label); }},
      {"edit", [this](const std::string& text) { return edit(text); }},
      {"edits", [this](const std::string&) { return edits(); }},
      {"yes", [this](const std::string& rest) { return answerYes(rest); }},
      {"greyed", [this](const std::string& name) { return greyed(name); }},
      {"show", [this](const std::string& name) { return show(name); }},
      {"save", [this](const std::string& path) { return save(path); }},
      {"load", [this](const std::string& path) { return load(path); }},
      {"grab", [this](const std::string& path) { return grab(path); }},
      {"held", [this](const std::string&) { return watch_.take(); }},
  };
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "panel_driver", ros::init_options::AnonymousName);
  QApplication application(argc, argv);
  pluginlib::ClassLoader<rviz::Panel> loader("rviz", "rviz::Panel");
  const std::unique_ptr<rviz::Panel> panel(
      loader.createUnmanagedInstance("place_memory/PlaceMemoryPanel"));
  panel->resize(340, 900);
  panel->show();
  Driver driver(*panel);
  QSocketNotifier input(0, QSocketNotifier::Read);
  QObject::connect(&input, &QSocketNotifier::activated, [&](int) {
    std::string line;
    if (!std::getline(std::cin, line)) return application.quit();
    try {
      const std::string answer = driver.obey(line);
      std::cout << "ok " << answer << std::endl;
    } catch (const std::exception& error) {
      std::cout << "failed " << error.what() << std::endl;
    }
  });
  return application.exec();
}
