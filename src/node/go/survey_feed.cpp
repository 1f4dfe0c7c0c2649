#include "node/go/survey_feed.h"

#include <utility>

namespace place_memory::node {

void SurveyFeed::begin() {
  const std::lock_guard<std::mutex> lock(mutex_);
  news_ = News();
  collects_ = true;
}

void SurveyFeed::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  news_ = News();
  collects_ = false;
}

SurveyFeed::News SurveyFeed::fetch() {
  News news;
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(news, news_);
  news_.doubt = news.doubt;
  return news;
}

void SurveyFeed::hear(const core::Pose2d& odom_from_base, const core::SonarReading& reading) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (collects_) news_.heard.push_back({odom_from_base, reading});
}

void SurveyFeed::follow(const core::MapChange& change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (collects_) news_.changes.push_back(change);
}

void SurveyFeed::setDoubt(double doubt) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (collects_) news_.doubt = doubt;
}

}  // namespace place_memory::node
