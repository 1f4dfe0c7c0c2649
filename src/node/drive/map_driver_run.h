#ifndef PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_RUN_H
#define PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_RUN_H

#include <utility>

#include "config/mapper_options.h"
#include "node/drive/drive_feed.h"
#include "node/drive/map_driver.h"
#include "node/drive/moment_order.h"

namespace place_memory::node {

/// One mapper, and what feeds it.
struct MapDriver::Run {
  Run(const config::Parameters& parameters, core::MapperMode mode, DriveEvents::LabelOf label,
      MapperFeed::Step step, MapperFeed::Heard heard)
      : mapper(config::mapperOptions(parameters, mode)),
        to_mapper(mapper, std::move(step), std::move(heard)),
        feed(parameters, losses, to_mapper),
        events(parameters.drive.largest_jump, std::move(label)) {}

  core::Mapper mapper;
  DriveLosses losses;
  MapperFeed to_mapper;
  DriveFeed feed;
  MomentOrder order;
  DriveEvents events;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_RUN_H
