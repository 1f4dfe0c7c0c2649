#ifndef PLACE_MEMORY_MAPPING_JOIN_OFFSET_H
#define PLACE_MEMORY_MAPPING_JOIN_OFFSET_H

#include "mapping/mapping_run.h"

namespace place_memory::mapping {

/// How far off a later session lies beside the places of the earlier ones that it came near, in the
/// median [m]; below 0: it is apart, or came near none.
double joinOffset(const core::Mapper& mapper, const MappingRun& later, const Truth& truth);

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_JOIN_OFFSET_H
