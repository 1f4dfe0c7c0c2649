// How the drive's map and the memory's follow each other.
#include <place_memory/MapEvent.h>
#include <ros/console.h>

#include <exception>

#include "node/base/ros_time.h"
#include "node/drive/map_driver.h"
#include "node/drive/map_driver_run.h"

namespace place_memory::node {
namespace {

// Moved poses are written so often at the most.
constexpr std::chrono::nanoseconds kBetweenKeeps = std::chrono::seconds(10);

}  // namespace

void MapDriver::keep() {
  if (mode() == config::Mode::kMap) {
    memory_.keep(run_->mapper.map());
  } else {
    try {
      memory_.keepTravels(run_->mapper.map());
    } catch (const core::PlaceMemoryError&) {
      // The map that is localized in may be read-only; that a store fails is said by whoever
      // watches it.
    }
  }
  kept_ = steadyNow();
  changed_ = false;
}

void MapDriver::tryKeeping(const std::function<void()>& keeping) {
  std::string problem;
  try {
    keeping();
  } catch (const core::PlaceMemoryError& error) {
    problem = error.what();
  }
  // It is tried again and again, and said once.
  if (!problem.empty() && keep_problem_.empty()) {
    say(MapEvent::TROUBLE, "the map cannot be kept: " + problem);
  }
  keep_problem_ = problem;
}

void MapDriver::keepIfDue() {
  const std::chrono::nanoseconds now = steadyNow();
  if (!changed_ || now - kept_ < kBetweenKeeps) return;
  kept_ = now;
  tryKeeping([this] { keep(); });
}

core::PlaceMemory::Learned MapDriver::learn(const core::Scan& scan, const std::string& label,
                                            bool force) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (!run_) return memory_.learn(scan, label, force);
  addStanding(scan);
  follow({});
  // The place gets an id that none of the drive's has.
  if (mode() == config::Mode::kMap) memory_.keepNewPlaces(run_->mapper.map());
  core::PlaceMemory::Learned learned = memory_.learn(scan, label, force);
  run_->mapper.adopt(learned.place.id, scan.end);
  changed_ = true;
  return learned;
}

void MapDriver::rename(const std::string& label, const std::string& new_label) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  memory_.rename(label, new_label);
  if (!run_) return;
  if (const auto place = memory_.place(new_label)) run_->mapper.setNamed(place->id);
}

void MapDriver::remove(const std::string& label) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (!run_) return memory_.remove(label);
  const auto place = memory_.place(label);
  memory_.remove(label);
  if (!place) return;
  run_->mapper.forget(place->id);
  if (current_ == place->id) current_ = core::kNoPlace;
  changed_ = true;
}

std::size_t MapDriver::clear() {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  const std::size_t count = memory_.clear();
  if (run_) beginAnew();
  return count;
}

void MapDriver::change(const std::function<void()>& work) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (run_) tryKeeping([this] { keep(); });
  work();
  if (run_) beginAnew();
}

std::vector<core::ClosureQuestion> MapDriver::closureQuestions() const {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  return run_ ? run_->mapper.closureQuestions() : std::vector<core::ClosureQuestion>();
}

std::optional<core::ClosureWord> MapDriver::judgeClosure(core::PlaceId place, bool confirm) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (!run_) return std::nullopt;
  core::Mapper& mapper = run_->mapper;
  const core::ClosureWord word = confirm ? mapper.confirmClosure(place) : mapper.cutClosure(place);
  if (word == core::ClosureWord::kNoQuestion) return word;
  changed_ = true;
  if (run_->to_mapper.newest()) onStep(*run_->to_mapper.newest(), false);
  return word;
}

void MapDriver::beginAnew() {
  const bool makes_map = mode() == config::Mode::kMap;
  std::string problem;
  try {
    begin(makes_map ? core::MapperMode::kMap : core::MapperMode::kLocalize);
    if (makes_map || !run_->mapper.places().empty()) return;
    problem = "the map has no place left to localize by";
  } catch (const std::exception& error) {
    problem = std::string("the map cannot be taken up: ") + error.what();
  }
  say(MapEvent::TROUBLE, problem + "; the mode is off");
  end();
  setModeTo(config::Mode::kOff);
}

}  // namespace place_memory::node
