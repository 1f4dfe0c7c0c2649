#include <actionlib/client/simple_action_client.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/ScanPlaceAction.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace place_memory::measure {
namespace {

using Clock = std::chrono::steady_clock;
using ScanClient = actionlib::SimpleActionClient<ScanPlaceAction>;

constexpr int kScans = 20;
constexpr int kCallsPerScan = 20;
const ros::Duration kPatience(60.0);

struct Times {
  std::vector<double> first;     ///< from the scan's result to the answer [ms]
  std::vector<double> kept;      ///< of a call over a connection that is kept [ms]
  std::vector<double> fresh;     ///< of a call over one of its own [ms]
  std::vector<double> matching;  ///< what the node itself says of the match [ms]
  std::size_t places = 0;
};

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// A scan at a standstill; returns when its result was there.
Clock::time_point scan(ScanClient& client) {
  ScanPlaceGoal goal;
  goal.headings = 1;
  goal.turn = ScanPlaceGoal::TURN_LISTEN;
  Clock::time_point ended;
  client.sendGoal(goal, [&ended](const auto&, const auto&) { ended = Clock::now(); });
  if (!client.waitForResult(kPatience)) throw std::runtime_error("a scan does not end");
  if (client.getResult()->status != ScanPlaceResult::SUCCEEDED) {
    throw std::runtime_error("a scan failed: " + client.getResult()->message);
  }
  return ended;
}

RecognizePlace::Response ask(ros::ServiceClient& service) {
  RecognizePlace call;
  if (!service.call(call)) throw std::runtime_error("~recognize_place gives no answer");
  if (call.response.status != RecognizePlace::Response::OK) {
    throw std::runtime_error("~recognize_place: " + call.response.message);
  }
  return call.response;
}

Times measure(ros::NodeHandle& node, const std::string& memory) {
  ScanClient scans(memory + "/scan", true);
  if (!scans.waitForServer(kPatience)) throw std::runtime_error("no node is there");
  const std::string service = memory + "/recognize_place";
  ros::service::waitForService(service);
  ros::ServiceClient kept = node.serviceClient<RecognizePlace>(service, true);
  ros::ServiceClient fresh = node.serviceClient<RecognizePlace>(service);

  scan(scans);
  LearnPlace here;
  here.request.label = "here";
  if (!ros::service::call(memory + "/learn_place", here) ||
      here.response.status != LearnPlace::Response::OK) {
    throw std::runtime_error("the place cannot be learned: " + here.response.message);
  }
  Times times;
  for (int i = 0; i < kScans; ++i) {
    const Clock::time_point ended = scan(scans);
    const RecognizePlace::Response answer = ask(kept);
    times.first.push_back(millisecondsSince(ended));
    times.places = answer.recognition.matches.size();
    for (int j = 0; j < kCallsPerScan; ++j) {
      Clock::time_point begin = Clock::now();
      times.matching.push_back(1e3 * ask(kept).recognition.match_duration.toSec());
      times.kept.push_back(millisecondsSince(begin));
      begin = Clock::now();
      ask(fresh);
      times.fresh.push_back(millisecondsSince(begin));
    }
  }
  return times;
}

void write(const std::string& path, const Times& times) {
  std::ofstream file(path);
  const auto row = [&file](const char* name, const std::vector<double>& values, const char* end) {
    file << "  \"" << name << "\": {\"median\": " << quantile(values, 0.5)
         << ", \"p95\": " << quantile(values, 0.95) << ", \"calls\": " << values.size() << "}"
         << end << "\n";
  };
  file << "{\n  \"places\": " << times.places << ",\n";
  row("scan_end_to_answer_ms", times.first, ",");
  row("call_kept_connection_ms", times.kept, ",");
  row("call_new_connection_ms", times.fresh, ",");
  row("match_duration_ms", times.matching, "");
  file << "}\n";
  if (!file.flush()) throw std::runtime_error(path + " cannot be written");
}

}  // namespace
}  // namespace place_memory::measure

/// Measures how long a live node takes from the end of a scan to the answer. Private parameters:
/// `memory`, name of the node; `out`, the file for the result.
int main(int argc, char** argv) {
  using namespace place_memory::measure;
  ros::init(argc, argv, "live_benchmark");
  try {
    ros::NodeHandle node;
    const ros::NodeHandle parameters("~");
    write(parameters.param<std::string>("out", "live.json"),
          measure(node, parameters.param<std::string>("memory", "place_memory")));
  } catch (const std::exception& error) {
    std::cerr << "place_memory_live_benchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
