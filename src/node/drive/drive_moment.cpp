#include "node/drive/drive_moment.h"

#include <tuple>

namespace place_memory::node {

const std::string& DriveMoment::frame() const {
  static const std::string kNone;
  if (const auto* measurement = std::get_if<core::Measurement>(&what)) return measurement->frame;
  if (const auto* moved = std::get_if<DrivenTransform>(&what)) {
    return moved->transform.child_frame_id;
  }
  return kNone;
}

bool DriveMoment::operator<(const DriveMoment& other) const {
  const std::size_t kind = what.index(), other_kind = other.what.index();
  return std::tie(stamp, kind, frame()) < std::tie(other.stamp, other_kind, other.frame());
}

}  // namespace place_memory::node
