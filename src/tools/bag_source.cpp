#include "tools/bag_source.h"

#include <rosbag/view.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "tools/bag_file.h"
#include "tools/clock_topic.h"

namespace place_memory::tools {
namespace {

std::vector<std::string> notesOn(const std::string& path, const BagClock& clock) {
  std::vector<std::string> notes;
  if (clock.offset != 0.0) {
    notes.push_back("in the bag " + path + " the recorder's clock is " +
                    inWords(std::fabs(clock.offset)) +
                    (clock.offset > 0.0 ? " ahead of" : " behind") +
                    " the header stamps; header stamps rule, and all times are theirs");
  }
  for (const auto& [input, late] : clock.strays) {
    notes.push_back("in the bag " + path + " what is on /" + input.first + " of frame '" +
                    input.second + "' is stamped " + inWords(std::fabs(late)) +
                    (late > 0.0 ? " before" : " after") + " the others: is the clock there right?");
  }
  return notes;
}

// Static transforms keep the stamp of when they were first sent.
bool tellsTheClock(const std::string& topic, const std::set<std::string>& topics) {
  return topic != "tf_static" && topics.count(topic) > 0;
}

void readConnections(const std::set<std::string>& topics, BagSource& source) {
  rosbag::View everything(*source.bag);
  if (everything.size() == 0) {
    throw std::runtime_error("the bag " + source.path + " holds no message");
  }
  for (const rosbag::ConnectionInfo* connection : everything.getConnections()) {
    const std::string topic = withoutSlash(connection->topic);
    source.layouts[connection->datatype] = stampLayout(connection->datatype, connection->msg_def);
    source.types[topic].insert(connection->datatype);
    source.names[topic].insert(connection->topic);
    if (topics.count(topic) > 0) refuseOtherDefinition(source.path, *connection);
  }
}

BagClock measureClock(const std::set<std::string>& topics, const BagSource& source) {
  ClockMeasurement measurement;
  const auto note = [&](const rosbag::MessageInstance& instance) {
    measurement.note(instance.getTime());
    // Where the bag is damaged, the events of that time will say so.
    const auto message = tryLoad(instance);
    if (!message) return;
    const auto origin = originOf(*message, source.layouts.at(instance.getDataType()));
    if (origin) measurement.note(*message, *origin, tellsTheClock(message->topic, topics));
  };
  for (const auto& [topic, names] : source.names) {
    rosbag::View view(*source.bag,
                      rosbag::TopicQuery(std::vector<std::string>(names.begin(), names.end())));
    for (const rosbag::MessageInstance& instance : view) {
      note(instance);
      if (topics.count(topic) == 0) break;  // of others when they begin, pictures among them
    }
  }
  return measurement.clock();
}

}  // namespace

std::string inWords(double number, const char* format) {
  char text[64];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}

std::vector<std::string> BagSource::namesOf(const std::set<std::string>& topics) const {
  std::vector<std::string> found;
  for (const std::string& topic : topics) {
    const auto in_bag = names.find(topic);
    if (in_bag == names.end()) continue;
    found.insert(found.end(), in_bag->second.begin(), in_bag->second.end());
  }
  return found;
}

BagSource openSource(const std::string& path, const std::set<std::string>& topics) {
  BagSource source;
  source.path = path;
  source.bag = std::make_unique<rosbag::Bag>();
  openBag(path, *source.bag);
  readConnections(topics, source);
  try {
    source.clock = measureClock(topics, source);
    source.notes = notesOn(path, source.clock);
    const std::string clocks = severalClocks(*source.bag);
    if (!clocks.empty()) source.notes.push_back("in the bag " + path + " " + clocks);
  } catch (const std::exception& error) {  // of rosbag, and of what decompresses
    throw std::runtime_error("the bag " + path + " is damaged: " + error.what());
  }
  return source;
}

}  // namespace place_memory::tools
