#ifndef PLACE_MEMORY_CORE_MEMORY_STORE_MERGE_H
#define PLACE_MEMORY_CORE_MEMORY_STORE_MERGE_H

#include <string>
#include <vector>

#include "core/store/place_store.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/scan.h"

namespace place_memory::core {

/// The scan from which a place of a store was learned, as far as the store knows it: odometry's
/// frame is that of the place's session. Throws StoreError.
Scan scanOf(const Place& place, const PlaceStore& store);

/// A place of another store that was RECOGNIZED as one of the map.
struct MergeSighting {
  PlaceId theirs = kNoPlace;
  PlaceId ours = kNoPlace;
  Pose2d ours_from_theirs;  ///< pose of their place in ours
};

struct MergePlan {
  std::vector<MapEdit> edits;
  MergeReport report;
};

/// How to take in the places of `theirs`, of which `store` has the rest. The frame of each of their
/// sessions is found by consensus: sightings, and places of one identity, say how it would lie, and
/// the most that agree with each other (within half a metre and a tenth of the way between them,
/// and 15 degrees) decide, if they are three or all places of the session, and twice as many as
/// those that agree on anything else. A place of theirs that was RECOGNIZED less than 0.6 m from
/// where ours was learned is ours; theirs is left out, and its links lead to ours. New places have
/// ids from `next_id` on, new sessions numbers from `next_session` on. Throws StoreError.
MergePlan planMerge(const PlaceMap& ours, const PlaceMap& theirs, const PlaceStore& store,
                    const std::vector<MergeSighting>& sightings, PlaceId next_id,
                    SessionId next_session);

/// The edits by which the map becomes that of `theirs`, numbered like planMerge()'s.
std::vector<MapEdit> replacingEdits(const PlaceMap& theirs, const PlaceStore& store,
                                    PlaceId next_id, SessionId next_session);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_STORE_MERGE_H
