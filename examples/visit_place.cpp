// Scans, learns the place or tells which one it is, and goes to another one from there.
//
//     visit_place learn LABEL | recognize | go LABEL [_node:=/place_memory]
#include <actionlib/client/simple_action_client.h>
#include <place_memory/GoToPlaceAction.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/ScanPlaceAction.h>
#include <ros/ros.h>

#include <iostream>
#include <string>

int main(int argc, char** argv) {
  ros::init(argc, argv, "visit_place", ros::init_options::AnonymousName);
  ros::NodeHandle own("~");
  const auto node = own.param<std::string>("node", "/place_memory");

  actionlib::SimpleActionClient<place_memory::ScanPlaceAction> scan(node + "/scan", true);
  scan.waitForServer();
  place_memory::ScanPlaceGoal goal;
  goal.turn = static_cast<std::uint8_t>(own.param("turn", 0));
  scan.sendGoalAndWait(goal);
  const auto scanned = scan.getResult();
  std::cout << scanned->message << '\n';
  if (scanned->status != place_memory::ScanPlaceResult::SUCCEEDED) return 1;

  const std::string word = argc > 1 ? argv[1] : "recognize";
  if (word == "learn" && argc == 3) {
    place_memory::LearnPlace learn;
    learn.request.label = argv[2];
    learn.request.scan_id = scanned->scan_id;
    if (!ros::service::call(node + "/learn_place", learn)) return 1;
    std::cout << learn.response.message << '\n';
    return learn.response.status;
  }
  place_memory::RecognizePlace recognize;
  recognize.request.scan_id = scanned->scan_id;
  if (!ros::service::call(node + "/recognize_place", recognize)) return 1;
  std::cout << recognize.response.message << '\n';
  for (const auto& match : recognize.response.recognition.matches) {
    std::cout << match.probability << ' ' << match.label << '\n';
  }
  if (word != "go" || argc != 3) return recognize.response.status;
  actionlib::SimpleActionClient<place_memory::GoToPlaceAction> go(node + "/go_to_place", true);
  go.waitForServer();
  place_memory::GoToPlaceGoal place;
  place.label = argv[2];
  go.sendGoalAndWait(place);
  std::cout << go.getResult()->message << '\n';
  return go.getResult()->status;
}
