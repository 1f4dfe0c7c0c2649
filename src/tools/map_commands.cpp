#include "tools/map_commands.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "config/load_parameters.h"
#include "core/memory/map_export.h"
#include "picture/grid_picture.h"
#include "picture/surface.h"
#include "picture/svg_text.h"
#include "tools/map_tables.h"
#include "tools/node_source.h"
#include "tools/record_table.h"
#include "tools/store_reports.h"
#include "tools/store_source.h"

namespace place_memory::tools {
namespace {

constexpr std::size_t kChangesShown = 20;
constexpr std::size_t kMatchesShown = 10;
constexpr int kPixelsPerCell = 8;

constexpr char kWhyNoCp[] =
    "A store that a node has open is not copied soundly by cp: SQLite writes a change page by "
    "page, "
    "and\nuntil it is whole the way back lies in the file's -journal, so that cp gets some of "
    "both. "
    "Ask the node for\na copy by its service ~save, or stop it first.";

/// East to the right, north up.
std::string placeAsPng(const core::EvidenceGrid& grid) {
  const picture::Color unsensed{0xc4, 0xc4, 0xc4};
  std::vector<picture::Color> pixels;
  constexpr int kWidth = core::kGridSize * kPixelsPerCell;
  for (int y = kWidth - 1; y >= 0; --y) {
    for (int x = 0; x < kWidth; ++x) {
      const int evidence = grid.at(y / kPixelsPerCell, x / kPixelsPerCell);
      pixels.push_back(evidence == 0 ? unsensed : picture::shadeOf(evidence));
    }
  }
  return picture::encodePng(*picture::makeSurface(pixels, kWidth));
}

const core::Place& placeOf(const core::MapSnapshot& map, const std::string& label) {
  const auto found = std::find_if(map.places.begin(), map.places.end(),
                                  [&](const core::Place& place) { return place.label == label; });
  if (found == map.places.end()) throw CommandError("there is no place \"" + label + "\"", kNo);
  return *found;
}

/// Does the commands, one each.
class Commands {
 public:
  Commands(const MapArguments& arguments, const config::Parameters& parameters, std::ostream& out,
           std::ostream& notes)
      : arguments_(arguments), parameters_(parameters), out_(out), notes_(notes) {}

  ExitStatus run() {
    if (arguments_.command == "check") return check();
    if (arguments_.command == "twins" || arguments_.command == "changes") return report();
    open();
    if (arguments_.command == "list") return list();
    if (arguments_.command == "show") return show();
    if (arguments_.command == "learn") return learn();
    if (arguments_.command == "recognize") return recognize();
    if (arguments_.command == "export") return say(source_->exportTo(arguments_.words.front()));
    if (arguments_.command == "merge") return merge();
    if (arguments_.command == "history") return history();
    if (arguments_.command == "undo") return undo();
    if (arguments_.command == "stats") return stats();
    if (arguments_.command == "go") return go();
    return plan();
  }

 private:
  void open() {
    if (!arguments_.node.empty()) {
      source_ = std::make_unique<NodeSource>(arguments_.node);
      return;
    }
    auto store = std::make_unique<StoreSource>(arguments_.store, parameters_);
    for (const std::string& sentence : store->setAside()) notes_ << sentence << '\n';
    source_ = std::move(store);
  }

  void print(const RecordTable& table) {
    if (arguments_.json) {
      table.printJson(out_);
    } else {
      table.print(out_);
    }
  }

  ExitStatus say(const std::string& sentence) {
    if (arguments_.json) {
      out_ << "{\"message\": " << jsonText(sentence) << "}\n";
    } else {
      out_ << sentence << '\n';
    }
    return kDone;
  }

  ExitStatus list() {
    print(placeTable(source_->map().places));
    return kDone;
  }

  ExitStatus show() {
    const core::MapSnapshot map = source_->map();
    const core::Place& place = placeOf(map, arguments_.words.front());
    print(placeTable({place}));
    if (!arguments_.json) {
      out_ << "identity " << core::identityInWords(place.identity) << "\n\n";
      linkTable(map, place).print(out_);
    }
    if (arguments_.png.empty()) return kDone;
    std::ofstream picture(arguments_.png, std::ios::binary);
    picture << placeAsPng(source_->grid(place.id));
    picture.close();
    if (!picture) throw CommandError("cannot write the picture " + arguments_.png);
    return kDone;
  }

  ScanChoice scanChoice() const {
    ScanChoice choice;
    if (!arguments_.words.empty()) choice.place = arguments_.words.front();
    choice.other_store = arguments_.from;
    choice.scan_now = arguments_.scan;
    return choice;
  }

  ExitStatus learn() {
    const ScanChoice choice = scanChoice();
    // A node's scan has no label of its own yet.
    const bool of_node = !arguments_.node.empty();
    return say(source_->learn(of_node ? choice.place : arguments_.label, choice));
  }

  ExitStatus recognize() {
    const Recognized found = source_->recognize(scanChoice());
    RecordTable table({"place", "probability", "score", "x", "y", "yaw"});
    for (std::size_t i = 0; i < std::min(kMatchesShown, found.matches.size()); ++i) {
      const Recognized::Match& match = found.matches[i];
      const core::Pose2d& pose = match.place_from_scan;
      table.add({match.label, Decimal{match.probability}, Decimal{match.score}, Decimal{pose.x},
                 Decimal{pose.y}, Decimal{pose.yaw}});
    }
    if (arguments_.json) {
      const core::Pose2d& robot = found.map_from_robot;
      out_ << "{\"verdict\": " << jsonText(found.verdict)
           << ", \"message\": " << jsonText(found.message);
      RecordTable pose({"x", "y", "yaw"});
      pose.add({Decimal{robot.x}, Decimal{robot.y}, Decimal{robot.yaw}});
      out_ << ", \"robot\": ";
      pose.printJson(out_);
      out_ << ", \"matches\": ";
      table.printJson(out_);
      out_ << "}\n";
    } else {
      out_ << found.verdict << (found.message.empty() ? "" : ": " + found.message) << "\n\n";
      table.print(out_);
    }
    return found.verdict == core::nameOf(core::Verdict::kRecognized) ? kDone : kNo;
  }

  ExitStatus plan() {
    const PlannedRoute route = source_->plan(arguments_.words[0], arguments_.words[1]);
    if (!route.problem.empty()) throw CommandError(route.problem, kNo);
    RecordTable table({"leg", "place"});
    for (std::size_t i = 0; i < route.labels.size(); ++i) {
      table.add({static_cast<std::int64_t>(i), route.labels[i]});
    }
    print(table);
    notes_ << picture::decimal(route.cost, 1) << " s, odds " << picture::decimal(route.odds, 2)
           << '\n';
    return kDone;
  }

  ExitStatus go() {
    const DrivenGoal goal =
        source_->go(arguments_.words.front(),
                    [this](const std::string& sentence) { notes_ << sentence << std::endl; });
    if (goal.end == DrivenGoal::End::kReached) return say(goal.message);
    throw CommandError(goal.message, goal.end == DrivenGoal::End::kNoWay ? kNo : kFailed);
  }

  ExitStatus merge() {
    std::vector<std::string> collisions;
    const ExitStatus status = say(source_->merge(arguments_.words.front(), collisions));
    for (const std::string& sentence : collisions) notes_ << sentence << '\n';
    return status;
  }

  ExitStatus history() {
    const auto changes = source_->history(arguments_.count == 0 ? kChangesShown : arguments_.count);
    print(historyTable(changes));
    return kDone;
  }

  ExitStatus undo() {
    try {
      print(historyTable(source_->undo(std::max<std::size_t>(1, arguments_.count))));
    } catch (const core::PlaceMemoryError& error) {
      if (error.reason() != core::PlaceMemoryError::Reason::kNothingToUndo) throw;
      throw CommandError(error.what(), kNo);
    }
    return kDone;
  }

  ExitStatus stats() {
    std::error_code error;
    const auto bytes =
        arguments_.store.empty() ? 0 : std::filesystem::file_size(arguments_.store, error);
    print(statsTable(source_->map(), bytes));
    return kDone;
  }

  ExitStatus report() {
    if (arguments_.store.empty()) {
      throw CommandError(
          "reports are made of a store: name it by --store, of a node the copy that "
          "its service ~save writes");
    }
    print(arguments_.command == "twins"
              ? twinTable(arguments_.store, parameters_)
              : changeTable(arguments_.store,
                            arguments_.words.empty() ? "" : arguments_.words.front(),
                            arguments_.from, parameters_));
    return kDone;
  }

  ExitStatus check() {
    if (arguments_.store.empty()) {
      throw CommandError(
          "a file is checked: name it by --store. Of a node check the copy that its "
          "service ~save writes");
    }
    std::vector<std::string> damages;
    try {
      damages = checkStore(arguments_.store, parameters_);
    } catch (const core::StoreError& error) {
      throw CommandError(std::string(error.what()) + '\n' + kWhyNoCp);
    }
    RecordTable table({"damage"});
    for (const std::string& sentence : damages) table.add({sentence});
    if (arguments_.json) {
      table.printJson(out_);
    } else if (damages.empty()) {
      out_ << "every row is as it was written\n";
    } else {
      for (const std::string& sentence : damages) out_ << sentence << '\n';
    }
    notes_ << kWhyNoCp << '\n';
    return damages.empty() ? kDone : kNo;
  }

  const MapArguments& arguments_;
  const config::Parameters& parameters_;
  std::ostream& out_;
  std::ostream& notes_;
  std::unique_ptr<MapSource> source_;
};

}  // namespace

ExitStatus runCommand(const MapArguments& arguments, std::ostream& out, std::ostream& notes) {
  const config::Parameters parameters = config::loadParameters(arguments.params);
  return Commands(arguments, parameters, out, notes).run();
}

}  // namespace place_memory::tools
