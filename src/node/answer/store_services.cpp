#include "node/answer/store_services.h"

#include <ros/console.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "config/store_directory.h"
#include "core/memory/map_export.h"
#include "node/answer/answer_words.h"
#include "node/answer/guarded_service.h"
#include "node/base/conversions.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

constexpr int kMostTries = 20;  // to write a map that others change

/// The path that a client names; nothing where it is refused, which is then the answer.
template <class Response>
std::optional<std::string> takePath(const config::Parameters& parameters, const std::string& path,
                                    Response& response) {
  try {
    return config::pathInside(parameters.store_directory, path);
  } catch (const std::invalid_argument& error) {
    response.status = Response::INVALID_PATH;
    response.message = error.what();
    return std::nullopt;
  }
}

std::string countInWords(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string inWords(const core::MergeReport& report) {
  std::string words = "added " + placesInWords(report.added);
  if (report.known > 0) words += ", " + std::to_string(report.known) + " were known already";
  words += "; " + countInWords(report.joined, "session") + " found in the map";
  if (report.apart > 0) {
    words += ", " + countInWords(report.apart, "session") +
             " not: too few of its places were recognised to say where it lies, so it stays apart "
             "until the robot recognises one";
  }
  if (!report.collisions.empty()) {
    words += "; " + countInWords(report.collisions.size(), "label") + " changed, see collisions";
  }
  return words;
}

/// Returns of how many places.
std::size_t exportTo(const std::string& path, const core::PlaceMemory& memory,
                     const config::Parameters& parameters, std::vector<std::string>& files) {
  for (int tries = 1;; ++tries) {
    const core::MapSnapshot map = memory.map();
    try {
      files = core::exportMap(
          map, [&memory](core::PlaceId id) { return memory.grid(id); }, parameters.grid.cell_size,
          parameters.sonar.prior, path);
      return map.places.size();
    } catch (const core::PlaceMemoryError& error) {
      // A place was removed meanwhile: it is not in the map as that is now.
      const bool is_gone = error.reason() == core::PlaceMemoryError::Reason::kUnknownPlace;
      if (!is_gone || tries == kMostTries) throw;
    }
  }
}

}  // namespace

StoreServices::StoreServices(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
                             MapDriver& driver, AnswerPublisher& publisher,
                             const config::Parameters& parameters)
    : memory_(memory),
      driver_(driver),
      publisher_(publisher),
      parameters_(parameters),
      spinner_(1, &queue_) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  servers_.push_back(advertiseGuarded(node, kSaveService, this, &StoreServices::save));
  servers_.push_back(advertiseGuarded(node, kLoadService, this, &StoreServices::load));
  servers_.push_back(advertiseGuarded(node, kMergeService, this, &StoreServices::merge));
  servers_.push_back(advertiseGuarded(node, kExportService, this, &StoreServices::exportMap));
  servers_.push_back(advertiseGuarded(node, kUndoService, this, &StoreServices::undo));
  spinner_.start();
}

StoreServices::~StoreServices() { spinner_.stop(); }

void StoreServices::save(const Save::Request& request, Save::Response& response) {
  const auto path = takePath(parameters_, request.path, response);
  if (!path) return;
  memory_.save(*path);
  response.path = *path;
  response.message = "saved " + placesInWords(memory_.size()) + " as " + *path;
  ROS_INFO("%s", response.message.c_str());
}

void StoreServices::load(const Load::Request& request, Load::Response& response) {
  const auto path = takePath(parameters_, request.path, response);
  if (!path) return;
  driver_.change([&] { response.places = static_cast<std::uint32_t>(memory_.load(*path)); });
  publisher_.overtake();
  response.message = "loaded " + placesInWords(response.places) + " of " + *path +
                     "; where the robot is among them is not known yet: recognise a place";
  ROS_INFO("%s", response.message.c_str());
}

void StoreServices::merge(const Merge::Request& request, Merge::Response& response) {
  const auto path = takePath(parameters_, request.path, response);
  if (!path) return;
  core::MergeReport report;
  driver_.change([&] { report = memory_.merge(*path); });
  response.added = static_cast<std::uint32_t>(report.added);
  response.known = static_cast<std::uint32_t>(report.known);
  response.joined = static_cast<std::uint32_t>(report.joined);
  response.apart = static_cast<std::uint32_t>(report.apart);
  for (const auto& collision : report.collisions) {
    response.collisions.push_back("there is a place " + quoted(collision.label) +
                                  " already: the new one is called " + quoted(collision.new_label));
  }
  response.message = inWords(report);
  ROS_INFO("%s: %s", path->c_str(), response.message.c_str());
}

void StoreServices::exportMap(const Export::Request& request, Export::Response& response) {
  const auto path = takePath(parameters_, request.path, response);
  if (!path) return;
  if (std::filesystem::exists(*path) && !std::filesystem::is_directory(*path)) {
    response.status = Export::Response::INVALID_PATH;
    response.message = *path + " is no folder: name one";
    return;
  }
  try {
    response.message = "wrote " +
                       placesInWords(exportTo(*path, memory_, parameters_, response.files)) +
                       " into " + *path;
  } catch (const core::PlaceMemoryError&) {
    throw;
  } catch (const std::runtime_error& error) {
    response.status = Export::Response::STORE_FAILED;
    response.message = error.what();
  }
}

void StoreServices::undo(const Undo::Request& request, Undo::Response& response) {
  const std::size_t count = std::max(request.count, 1U);
  std::vector<core::PastChange> changes;
  if (request.look != 0) {
    changes = memory_.history(count);
  } else {
    driver_.change([&] { changes = memory_.undo(count); });
  }
  for (const core::PastChange& change : changes) {
    response.changes.push_back(change.words + (change.can_be_undone ? "" : " (cannot be undone)"));
    response.stamps.push_back(toRosTime(change.stamp));
  }
  if (request.look != 0) {
    response.message = changes.empty() ? "there is nothing to undo"
                                       : "undoing would take back what " +
                                             countInWords(changes.size(), "change") + " did";
    return;
  }
  publisher_.overtake();
  response.message = "undone: " + response.changes.front();
  for (std::size_t i = 1; i < response.changes.size(); ++i) {
    response.message += "; " + response.changes[i];
  }
  ROS_INFO("%s", response.message.c_str());
}

}  // namespace place_memory::node
