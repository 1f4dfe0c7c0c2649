#include "config/mapper_options.h"

namespace place_memory::config {

core::MapperOptions mapperOptions(const Parameters& parameters, core::MapperMode mode) {
  core::MapperOptions options;
  options.mode = mode;
  options.cell_size = parameters.grid.cell_size;
  options.sonar = parameters.sonar;
  options.recognizer = parameters.match.recognizer;
  return options;
}

}  // namespace place_memory::config
