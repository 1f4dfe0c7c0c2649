#include "tools/map_commands.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "config/load_parameters.h"
#include "core/memory/map_export.h"
#include "tools/node_source.h"
#include "tools/png.h"
#include "tools/record_table.h"
#include "tools/store_source.h"

namespace place_memory::tools {
namespace {

constexpr std::size_t kChangesShown = 20;
constexpr std::size_t kMatchesShown = 10;
constexpr std::uint32_t kPixelsPerCell = 8;

constexpr char kWhyNoCp[] =
    "A store that a node has open is not copied soundly by cp: SQLite writes a change page by "
    "page, "
    "and\nuntil it is whole the way back lies in the file's -journal, so that cp gets some of "
    "both. "
    "Ask the node for\na copy by its service ~save, or stop it first.";

std::int64_t integer(std::size_t number) { return static_cast<std::int64_t>(number); }

/// In UTC; empty where there is none.
std::string timeInWords(std::chrono::nanoseconds time) {
  if (time.count() == 0) return "";
  const auto seconds =
      static_cast<std::time_t>(std::chrono::duration_cast<std::chrono::seconds>(time).count());
  std::tm date{};
  gmtime_r(&seconds, &date);
  char text[sizeof("2000-00-00T00:00:00Z") + 8];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &date);
  return text;
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
    throw CommandError("command '" + arguments_.command + "' is not built in");
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
    RecordTable table({"id", "label", "session", "x", "y", "yaw", "learned"});
    for (const core::Place& place : source_->map().places) {
      const core::Pose2d& pose = place.map_from_place;
      table.add({place.id, place.label, place.session, Decimal{pose.x}, Decimal{pose.y},
                 Decimal{pose.yaw}, timeInWords(place.learned)});
    }
    print(table);
    return kDone;
  }

  ExitStatus show() {
    const core::MapSnapshot map = source_->map();
    const core::Place& place = placeOf(map, arguments_.words.front());
    const core::Pose2d& pose = place.map_from_place;
    RecordTable table({"id", "label", "session", "x", "y", "yaw", "learned", "identity"});
    table.add({place.id, place.label, place.session, Decimal{pose.x}, Decimal{pose.y},
               Decimal{pose.yaw}, timeInWords(place.learned),
               core::identityInWords(place.identity)});
    print(table);
    if (!arguments_.json) printLinks(map, place);
    if (arguments_.png.empty()) return kDone;
    std::ofstream picture(arguments_.png, std::ios::binary);
    picture << asPng(pictureOf(source_->grid(place.id), kPixelsPerCell));
    picture.close();
    if (!picture) throw CommandError("cannot write the picture " + arguments_.png);
    return kDone;
  }

  void printLinks(const core::MapSnapshot& map, const core::Place& place) {
    std::map<core::PlaceId, std::string> labels;
    for (const core::Place& other : map.places) labels[other.id] = other.label;
    RecordTable table({"linked to", "metres", "arrived", "gave up"});
    for (const core::PlaceLink& link : map.links) {
      if (link.first != place.id && link.second != place.id) continue;
      const bool is_first = link.first == place.id;
      const core::LinkDirection& there = is_first ? link.forward : link.backward;
      table.add({labels[is_first ? link.second : link.first],
                 Decimal{std::hypot(link.first_from_second.x, link.first_from_second.y), 2},
                 std::int64_t{there.succeeded}, std::int64_t{there.failed}});
    }
    if (table.size() > 0) out_ << '\n';
    table.print(out_);
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

  ExitStatus merge() {
    std::vector<std::string> collisions;
    const ExitStatus status = say(source_->merge(arguments_.words.front(), collisions));
    for (const std::string& sentence : collisions) notes_ << sentence << '\n';
    return status;
  }

  void print(const std::vector<core::PastChange>& changes) {
    RecordTable table({"back", "made", "change"});
    std::int64_t back = 0;
    for (const core::PastChange& change : changes) {
      table.add({++back, timeInWords(change.stamp),
                 change.words + (change.can_be_undone ? "" : " (cannot be undone)")});
    }
    print(table);
  }

  ExitStatus history() {
    const auto changes = source_->history(arguments_.count == 0 ? kChangesShown : arguments_.count);
    print(changes);
    return kDone;
  }

  ExitStatus undo() {
    try {
      print(source_->undo(std::max<std::size_t>(1, arguments_.count)));
    } catch (const core::PlaceMemoryError& error) {
      if (error.reason() != core::PlaceMemoryError::Reason::kNothingToUndo) throw;
      throw CommandError(error.what(), kNo);
    }
    return kDone;
  }

  ExitStatus stats() {
    const core::MapSnapshot map = source_->map();
    std::set<core::SessionId> sessions;
    for (const core::Place& place : map.places) sessions.insert(place.session);
    double way = 0.0;
    std::int64_t arrived = 0;
    std::int64_t gave_up = 0;
    for (const core::PlaceLink& link : map.links) {
      way += std::hypot(link.first_from_second.x, link.first_from_second.y);
      arrived += link.forward.succeeded + link.backward.succeeded;
      gave_up += link.forward.failed + link.backward.failed;
    }
    RecordTable table({"places", "links", "sessions", "metres of links", "arrived", "gave up",
                       "version", "changed", "bytes"});
    std::error_code error;
    const auto bytes =
        arguments_.store.empty() ? 0 : std::filesystem::file_size(arguments_.store, error);
    table.add({integer(map.places.size()), integer(map.links.size()), integer(sessions.size()),
               Decimal{way, 1}, arrived, gave_up, static_cast<std::int64_t>(map.version),
               timeInWords(map.stamp), static_cast<std::int64_t>(bytes)});
    print(table);
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
