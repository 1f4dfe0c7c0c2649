#include "tools/command_line.h"

#include <boost/program_options.hpp>
#include <stdexcept>
#include <utility>

#include "config/store_path.h"

namespace place_memory::tools {
namespace {

namespace po = boost::program_options;

constexpr char kStray[] = "stray";

po::options_description describe(Arguments& arguments) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("help,h", "show this text");
  add("bag", po::value(&arguments.bags)->required()->multitoken()->composing(),
      "rosbag with sonar, heading and tf; several, as the parts of a long recording, are read as "
      "one");
  add("events", po::value(&arguments.events),
      "table of what to do: start,end,action,label,heading_window,force [s, s, learn|recognize, "
      "text, rad, true|false]; times are those of header stamps; +12.5: so many seconds after the "
      "first one; force may be left out. Without a table every stretch where the robot stands or "
      "turns on the spot is recognized, and learned where no place fits");
  add("out", po::value(&arguments.out), "table of results to write, a row for each event");
  add("report", po::value(&arguments.report),
      "page to write (HTML, all in one file): pictures of each scan and its match, what was left "
      "out and why, the map");
  add("params", po::value(&arguments.params)->composing(),
      "parameters, laid out as config/place_memory.yaml; where several files give one, the last "
      "holds");
  add("store", po::value(&arguments.store), "file of places, instead of the parameter store");
  add("mode", po::value(&arguments.drive.mode),
      "map: make a map of the whole drive, or go on with the one in the store; localize: tell "
      "where "
      "the robot is in the map of the store, which stays as it is. Instead of --events and --out "
      "there are then, each of them if it is wanted:");
  add("trajectory", po::value(&arguments.drive.trajectory),
      "table to write of where the robot is, as it was known at each moment: t,x,y,yaw,lost");
  add("final", po::value(&arguments.drive.final_way),
      "table to write of the same way as the map lies at the end: t,x,y,yaw");
  add("map", po::value(&arguments.drive.map),
      "table to write of the places: id,label,t,x,y,yaw of the robot when it was made");
  add("answers", po::value(&arguments.drive.answers),
      "table to write of what became of each scan: "
      "t,decision,place,dx,dy,dyaw,belief,lost,reason");
  add("png", po::value(&arguments.drive.png),
      "picture to write: the building, its places and links, and the way driven");
  return options;
}

// What belongs to events does not go with a drive, and the other way about.
void checkTogether(const Arguments& arguments) {
  const DriveArguments& drive = arguments.drive;
  if (drive.mode.empty()) {
    if (arguments.out.empty())
      throw std::runtime_error("the option '--out' is required but missing");
    for (const auto& [option, path] :
         {std::make_pair("--trajectory", drive.trajectory),
          std::make_pair("--final", drive.final_way), std::make_pair("--map", drive.map),
          std::make_pair("--answers", drive.answers), std::make_pair("--png", drive.png)}) {
      if (!path.empty()) throw std::runtime_error(std::string(option) + " needs --mode");
    }
    return;
  }
  if (drive.mode != "map" && drive.mode != "localize") {
    throw std::runtime_error("--mode is map or localize, not '" + drive.mode + "'");
  }
  if (!arguments.events.empty() || !arguments.out.empty() || !arguments.report.empty()) {
    throw std::runtime_error("--events, --out and --report do not go with --mode: leave them out");
  }
}

// Empty where none was given.
void makeAbsolute(std::string& store) {
  const std::string problem = config::checkStorePath(store);
  if (!problem.empty()) {
    throw std::runtime_error("--store: " + problem + ", not '" + store + "'");
  }
  store = config::absoluteStorePath(store);
}

}  // namespace

std::optional<Arguments> readArguments(int argc, const char* const* argv, std::ostream& help) {
  Arguments arguments;
  const po::options_description options = describe(arguments);
  std::vector<std::string> stray;
  po::options_description hidden;
  hidden.add_options()(kStray, po::value(&stray));
  po::options_description all;
  all.add(options).add(hidden);
  po::positional_options_description positions;
  positions.add(kStray, -1);

  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positions).run(), given);
  if (given.count("help") > 0) {
    help << "usage: place_memory_bag --bag F... [--events F] --out F [--report F] [--params F]... "
            "[--store F]\n"
            "       place_memory_bag --bag F... --mode map|localize [--trajectory F] [--final F] "
            "[--map F] [--answers F] [--png F] [--params F]... [--store F]\n\n"
         << options
         << "\nExit status: 0: every event was answered; 3: the table of results is complete, but "
            "some\nevents failed; 1: nothing was done, or not all of it, as the message says.\n";
    return std::nullopt;
  }
  if (given.count(kStray) > 0) {
    throw std::runtime_error("what is '" + given[kStray].as<std::vector<std::string>>().front() +
                             "' for? Each argument needs its option; --help lists them");
  }
  po::notify(given);
  checkTogether(arguments);
  makeAbsolute(arguments.store);
  return arguments;
}

}  // namespace place_memory::tools
