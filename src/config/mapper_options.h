#ifndef PLACE_MEMORY_CONFIG_MAPPER_OPTIONS_H
#define PLACE_MEMORY_CONFIG_MAPPER_OPTIONS_H

#include "config/parameters.h"
#include "core/mapping/mapper.h"

namespace place_memory::config {

/// Of the mapper that the parameters describe, in that mode.
core::MapperOptions mapperOptions(const Parameters& parameters, core::MapperMode mode);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_MAPPER_OPTIONS_H
