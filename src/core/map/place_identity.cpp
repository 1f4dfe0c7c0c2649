#include "core/map/place_identity.h"

#include <cstring>
#include <random>

namespace place_memory::core {

PlaceIdentity makePlaceIdentity() {
  std::random_device source;
  PlaceIdentity identity{};
  for (std::size_t at = 0; at < identity.size(); at += sizeof(std::uint32_t)) {
    const std::uint32_t bits = source();
    std::memcpy(identity.data() + at, &bits, sizeof(bits));
  }
  return identity;
}

}  // namespace place_memory::core
