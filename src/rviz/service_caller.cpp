#include "rviz/service_caller.h"

#include <algorithm>

namespace place_memory::panel {

bool ServiceCaller::Pending::isOver() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return over_;
}

bool ServiceCaller::Pending::connected(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!over_) client_ = client;
  return !over_;
}

void ServiceCaller::Pending::finish(const std::function<void()>& tell) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    client_ = ros::ServiceClient();
    if (over_) return;
    over_ = true;
  }
  tell();
}

void ServiceCaller::Pending::breakOff(const std::function<void()>& tell) {
  ros::ServiceClient client;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (over_) return;
    over_ = true;
    client = client_;
  }
  if (tell) tell();
  client.shutdown();  // the call returns, on its own thread
}

ServiceCaller::~ServiceCaller() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::shared_ptr<Pending>& pending : pending_) pending->drop();
}

void ServiceCaller::expire(Clock::time_point now) {
  std::vector<std::shared_ptr<Pending>> due;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto is_over = [](const std::shared_ptr<Pending>& call) { return call->isOver(); };
    pending_.erase(std::remove_if(pending_.begin(), pending_.end(), is_over), pending_.end());
    for (const std::shared_ptr<Pending>& call : pending_) {
      if (call->isDue(now)) due.push_back(call);
    }
  }
  for (const std::shared_ptr<Pending>& call : due) call->timeOut();
}

}  // namespace place_memory::panel
