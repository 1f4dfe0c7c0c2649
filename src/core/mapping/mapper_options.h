#ifndef PLACE_MEMORY_CORE_MAPPING_MAPPER_OPTIONS_H
#define PLACE_MEMORY_CORE_MAPPING_MAPPER_OPTIONS_H

#include "core/mapping/closure_candidates.h"
#include "core/mapping/graph_thinning.h"
#include "core/mapping/moving_scan.h"
#include "place_memory/core/recognizer_options.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

enum class MapperMode {
  kMap,       ///< new places are made, and the map corrects itself
  kLocalize,  ///< the map stays as it is
};

struct MapperOptions {
  MapperMode mode = MapperMode::kMap;
  MovingScanOptions scan;
  double spacing = 1.3;    ///< least distance of a new place from all others [m]
  double doubled = 0.6;    ///< of two places nearer than this after a correction the newer goes [m]
  ClosureOptions closure;  ///< of loops
  ClosureOptions join{10,  7.0, 2.0, 20.0, 4.0,
                      6.0, 5,   5,   0.0,  0.65};  ///< of a session with the map
  /// Of what was driven since the robot seemed lost: perhaps it never was.
  ClosureOptions rejoin{10, 7.0, 2.0, 20.0, 4.0, 6.0, 5, 5, 4.0, 0.65, 2};
  /// Of a robot that thinks to be on new ground, and is carried to where it was: rooms look alike.
  ClosureOptions carried{12, 8.0, 2.0, 24.0, 5.0, 6.0, 5, 6, 4.0, 0.65};
  ClosureOptions relocate{2,   0.2, 0.0, 4.0, 2.0,
                          4.0, 3,   1,   0.0, 0.0};  ///< of a robot that only asks where it is
  double cell_size = kDefaultCellSize;               ///< [m]
  ThinningOptions thinning;
  SonarModelOptions sonar;
  RecognizerOptions recognizer;
  bool keep_way = false;  ///< remember scans that are thinned out, for way(): it grows with the way
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_MAPPER_OPTIONS_H
