// Learns and recognizes places from a rosbag, through the very pipeline of the node.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "config/load_parameters.h"
#include "config/memory_options.h"
#include "place_memory/core/place_memory.h"
#include "support/progress_bar.h"
#include "support/text.h"
#include "tools/bag_file.h"
#include "tools/bag_scanner.h"
#include "tools/child_process.h"
#include "tools/command_line.h"
#include "tools/drive_run.h"
#include "tools/event_table.h"
#include "tools/result_table.h"
#include "tools/standing_stretches.h"

namespace place_memory::tools {
namespace {

// Exit statuses beside EXIT_SUCCESS: every event was answered; EXIT_FAILURE: nothing was done, or
// not all of it.
constexpr int kSomeEventsFailed = 3;

std::vector<Event> loadEvents(const Arguments& arguments, const config::Parameters& parameters,
                              const ros::Time& bag_start) {
  if (arguments.events.empty()) return findEvents(arguments.bag, parameters);
  std::istringstream table(support::readWholeFile(arguments.events));
  return readEvents(table, arguments.events, parameters.match.heading_window, bag_start);
}

/// Opens the table of results and writes its header.
std::ofstream openTable(const std::string& path) {
  std::ofstream table(path);
  writeHeader(table);
  table.flush();
  if (!table) throw std::runtime_error("cannot write the results " + path);
  return table;
}

// A visit becomes what it turns out to be.
Result runEvent(Event& event, const core::Scan& scan, core::PlaceMemory& memory) {
  const Result result = run(event, scan, memory);
  const bool is_unknown = result.verdict == core::nameOf(core::Verdict::kUnknown);
  if (!event.visit || !is_unknown) return result;
  event.action = Action::kLearn;
  return run(event, scan, memory);
}

Result answer(Event& event, const BagScanner& scanner, const BagTimes& times,
              core::PlaceMemory& memory, const std::function<void(const std::string&)>& note) {
  Result result;
  node::ScanOutcome outcome;
  try {
    outcome = scanner.scan(event.start, event.end);
  } catch (const std::exception& error) {  // of rosbag, and of what messages are made from
    result.status = "damaged_bag";
    result.message = std::string("the bag is damaged there: ") + error.what();
    return result;
  }
  if (!outcome.problem.empty()) note(outcome.problem);
  if (outcome.scan) return runEvent(event, *outcome.scan, memory);
  result.status = node::toString(outcome.status);
  result.message = outcome.message;
  const std::string missing = times.missing(event.start, event.end);
  if (!missing.empty()) result.message += (result.message.empty() ? "" : "; ") + missing;
  return result;
}

void tell(std::size_t number, const Result& result, support::ProgressBar& bar) {
  std::string text = "event " + std::to_string(number);
  if (result.status != "ok") text += ": " + result.status;
  if (!result.message.empty()) text += ": " + result.message;
  if (result.status != "ok" || !result.message.empty()) bar.note(text);
}

/// Returns how many events failed.
std::size_t answerAll(std::vector<Event>& events, const BagScanner& scanner, const BagTimes& times,
                      core::PlaceMemory& memory, std::ostream& table) {
  std::size_t failed = 0;
  support::ProgressBar bar(events.size(), "events", std::cerr);
  for (std::size_t i = 0; i < events.size() && table; ++i) {
    bar.show(i);
    const auto note = [&](const std::string& text) {
      bar.note("event " + std::to_string(i + 1) + ": " + text);
    };
    const Result result = answer(events[i], scanner, times, memory, note);
    if (result.status != "ok") ++failed;
    tell(i + 1, result, bar);
    writeRow(events[i], result, table);
    table.flush();
  }
  bar.show(events.size());
  bar.finish();
  return failed;
}

// Its static transforms are read at once.
BagScanner openScanner(const std::string& bag, const config::Parameters& parameters) {
  try {
    return BagScanner(bag, parameters);
  } catch (const ros::Exception& error) {
    throw std::runtime_error("the bag " + bag + " is damaged: " + error.what());
  }
}

int process(const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  config::Parameters parameters = config::loadParameters(arguments.params);
  if (!arguments.store.empty()) parameters.store = arguments.store;
  const BagTimes times = checkBag(arguments.bag, parameters);
  if (!arguments.drive.mode.empty()) {
    runDrive(arguments.bag, arguments.drive, parameters);
    return EXIT_SUCCESS;
  }
  std::vector<Event> events = loadEvents(arguments, parameters, times.first);
  const BagScanner scanner = openScanner(arguments.bag, parameters);
  core::PlaceMemory memory(config::memoryOptions(parameters));
  std::ofstream table = openTable(arguments.out);
  const std::size_t failed = answerAll(events, scanner, times, memory, table);
  table.close();
  if (!table) throw std::runtime_error("cannot write the results " + arguments.out);

  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::cerr << events.size() << " events, " << failed << " failed, in " << std::fixed
            << std::setprecision(1) << took.count() << " s";
  if (!parameters.store.empty()) std::cerr << "; the places are kept in " << parameters.store;
  std::cerr << '\n';
  return failed == 0 ? EXIT_SUCCESS : kSomeEventsFailed;
}

}  // namespace

/// The exit status.
int runTool(int argc, char** argv) {
  const auto guarded = [](const std::function<int()>& work) {
    try {
      return work();
    } catch (const std::exception& error) {
      std::cerr << "place_memory_bag: " << error.what() << '\n';
      return EXIT_FAILURE;
    }
  };
  return guarded([&] {
    const auto arguments = readArguments(argc, argv, std::cout);
    if (!arguments) return EXIT_SUCCESS;
    return runInChild(
        [&] { return guarded([&] { return process(*arguments); }); },
        "the bag " + arguments->bag + " is damaged, most likely" +
            (arguments->out.empty() ? std::string()
                                    : ". What was answered before is in " + arguments->out));
  });
}

}  // namespace place_memory::tools

int main(int argc, char** argv) { return place_memory::tools::runTool(argc, argv); }
