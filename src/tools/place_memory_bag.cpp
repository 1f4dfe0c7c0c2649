// Learns and recognizes places from a rosbag, through the very pipeline of the node.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "config/load_parameters.h"
#include "config/memory_options.h"
#include "place_memory/core/place_memory.h"
#include "support/text.h"
#include "tools/bag_scanner.h"
#include "tools/bag_set.h"
#include "tools/child_process.h"
#include "tools/command_line.h"
#include "tools/drive_run.h"
#include "tools/event_answers.h"
#include "tools/event_table.h"
#include "tools/report_page.h"
#include "tools/result_table.h"
#include "tools/standing_stretches.h"

namespace place_memory::tools {
namespace {

// Exit statuses beside EXIT_SUCCESS: every event was answered; EXIT_FAILURE: nothing was done, or
// not all of it.
constexpr int kSomeEventsFailed = 3;

std::vector<Event> loadEvents(const Arguments& arguments, const config::Parameters& parameters,
                              const BagSet& bags) {
  if (arguments.events.empty()) return findEvents(bags, parameters);
  std::istringstream table(support::readWholeFile(arguments.events));
  return readEvents(table, arguments.events, parameters.match.recognizer.heading_window,
                    bags.first());
}

/// Opens the table of results and writes its header.
std::ofstream openTable(const std::string& path) {
  std::ofstream table(path);
  writeHeader(table);
  table.flush();
  if (!table) throw std::runtime_error("cannot write the results " + path);
  return table;
}

/// A place whose grid cannot be read is drawn without it.
core::FusedMap::GridOf gridsOf(const core::PlaceMemory& memory) {
  return [&memory](core::PlaceId id) -> std::shared_ptr<const core::EvidenceGrid> {
    try {
      return std::make_shared<const core::EvidenceGrid>(memory.grid(id));
    } catch (const core::PlaceMemoryError&) {
      return nullptr;
    }
  };
}

int process(const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  config::Parameters parameters = config::loadParameters(arguments.params);
  if (!arguments.store.empty()) parameters.store = arguments.store;
  std::vector<std::string> topics = parameters.sonar_topics;
  for (const std::string& topic : {parameters.heading_topic, parameters.odom_topic}) {
    if (!topic.empty()) topics.push_back(topic);
  }
  const BagSet bags(arguments.bags, topics);
  BagScanner scanner(bags, parameters);
  if (!arguments.drive.mode.empty()) {
    for (const std::string& note : bags.notes()) std::cerr << "place_memory_bag: " << note << '\n';
    runDrive(bags, scanner, arguments.drive, parameters);
    return EXIT_SUCCESS;
  }
  std::vector<Event> events = loadEvents(arguments, parameters, bags);
  for (const std::string& note : bags.notes()) std::cerr << "place_memory_bag: " << note << '\n';
  core::PlaceMemory memory(config::memoryOptions(parameters));
  std::optional<ReportPage> report;
  if (!arguments.report.empty()) report.emplace(arguments.report, bags.name(), bags.notes());
  std::ofstream table = openTable(arguments.out);
  EventAnswers answers(bags, scanner, memory, table, report ? &*report : nullptr);
  const std::size_t failed = answers.answerAll(events);
  table.close();
  if (!table) throw std::runtime_error("cannot write the results " + arguments.out);
  if (report) report->finish(memory.map(), gridsOf(memory), parameters.grid.cell_size);

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
        (arguments->bags.size() == 1 ? "the bag " + arguments->bags.front() + " is"
                                     : std::string("one of the bags is")) +
            " damaged, most likely" +
            (arguments->out.empty() ? std::string()
                                    : ". What was answered before is in " + arguments->out));
  });
}

}  // namespace place_memory::tools

int main(int argc, char** argv) { return place_memory::tools::runTool(argc, argv); }
