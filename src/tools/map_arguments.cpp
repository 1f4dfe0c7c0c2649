#include "tools/map_arguments.h"

#include <algorithm>
#include <array>
#include <boost/program_options.hpp>
#include <stdexcept>

#include "config/store_path.h"

namespace place_memory::tools {
namespace {

namespace po = boost::program_options;

struct Command {
  const char* name;
  std::size_t least_words;
  std::size_t most_words;
  const char* use;
};

constexpr std::array<Command, 14> kCommands{{
    {"list", 0, 0, "list                  every place"},
    {"show", 1, 1,
     "show PLACE            one place, its links and its grid; --png FILE: as picture"},
    {"learn", 0, 1,
     "learn [PLACE]         node: its newest scan, or --scan, as PLACE; store: the scan of PLACE "
     "of --from FILE"},
    {"recognize", 0, 1,
     "recognize [PLACE]     node: its newest scan, or --scan; store: the scan of PLACE, of --from "
     "FILE"},
    {"export", 1, 1, "export FOLDER         CSV, GraphML, and grids as map_server reads them"},
    {"merge", 1, 1, "merge FILE            take in the places of another store"},
    {"history", 0, 0, "history               what can be undone, newest first; --count N"},
    {"undo", 0, 0, "undo                  take back the newest change; --count N of them"},
    {"stats", 0, 0, "stats                 numbers of the map"},
    {"check", 0, 0, "check                 read every row of a store, and name what is damaged"},
    {"twins", 0, 0, "twins                 places that look alike, and what parts them"},
    {"changes", 0, 1,
     "changes [PLACE]       what has changed at places since they were learned, or as the places "
     "of --from FILE show"},
    {"plan", 2, 2, "plan FROM TO          the way from place to place"},
    {"go", 1, 1, "go PLACE              node: drives the robot there; Ctrl-C cancels it"},
}};

po::options_description describe(MapArguments& arguments) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("help,h", "show this text");
  add("store,s", po::value(&arguments.store), "the file, which no node has open");
  add("node,n", po::value(&arguments.node), "name of a node that runs, instead");
  add("params", po::value(&arguments.params)->composing(),
      "parameters, laid out as config/place_memory.yaml, of what differs from it");
  add("json", po::bool_switch(&arguments.json), "print JSON");
  add("png", po::value(&arguments.png), "picture to write, of show");
  add("from", po::value(&arguments.from), "another store, of learn and recognize");
  add("label", po::value(&arguments.label), "of the place that learn makes in a store");
  add("scan", po::bool_switch(&arguments.scan), "the node scans first, of learn and recognize");
  add("count", po::value(&arguments.count), "of changes, of history and undo");
  return options;
}

void writeHelp(const po::options_description& options, std::ostream& help) {
  help << "usage: place_memory COMMAND (--store FILE | --node NAME) [OPTION]...\n\nCommands:\n";
  for (const Command& command : kCommands) help << "  " << command.use << '\n';
  help << '\n'
       << options
       << "\nExit status: 0: done; 1: it could not be done, as the message says; 2: done, and the "
          "answer\nis no: not recognized, no way, damaged, nothing to undo; 3: the node does not "
          "answer.\n";
}

void check(const MapArguments& arguments) {
  const auto command = std::find_if(kCommands.begin(), kCommands.end(), [&](const Command& known) {
    return arguments.command == known.name;
  });
  if (command == kCommands.end()) {
    throw std::runtime_error(arguments.command.empty()
                                 ? "which command? --help lists them"
                                 : "there is no command '" + arguments.command +
                                       "'; --help lists them");
  }
  const std::size_t words = arguments.words.size();
  if (words < command->least_words || words > command->most_words) {
    throw std::runtime_error(std::string("use: place_memory ") + command->use);
  }
  if (arguments.store.empty() == arguments.node.empty()) {
    throw std::runtime_error("give either --store FILE or --node NAME");
  }
}

}  // namespace

std::optional<MapArguments> readMapArguments(int argc, const char* const* argv,
                                             std::ostream& help) {
  MapArguments arguments;
  const po::options_description options = describe(arguments);
  po::options_description hidden;
  hidden.add_options()("command", po::value(&arguments.command))("words",
                                                                 po::value(&arguments.words));
  po::options_description all;
  all.add(options).add(hidden);
  po::positional_options_description positions;
  positions.add("command", 1).add("words", -1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positions).run(), given);
  if (given.count("help") > 0) {
    writeHelp(options, help);
    return std::nullopt;
  }
  po::notify(given);
  check(arguments);
  const std::string problem = config::checkStorePath(arguments.store);
  if (!problem.empty()) throw std::runtime_error("--store: " + problem);
  arguments.store = config::absoluteStorePath(arguments.store);
  return arguments;
}

}  // namespace place_memory::tools
