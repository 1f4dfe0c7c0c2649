#include "sim/scene/person.h"

namespace place_memory::sim {

Person::Person(std::size_t from, std::size_t to, Rng& rng)
    : from_(from), to_(to), speed_(uniform(rng, 0.7, 1.5)), sideways_(uniform(rng, -0.3, 0.3)) {}

void Person::step(double dt, const Walkways& ways, Rng& rng) {
  walked_ += speed_ * dt;
  for (;;) {
    const double length = norm(ways.places[to_] - ways.places[from_]);
    if (walked_ < length || length <= 0.0) return;
    walked_ -= length;
    chooseNext(ways, rng);
  }
}

void Person::chooseNext(const Walkways& ways, Rng& rng) {
  const std::vector<std::size_t>& options = ways.neighbours[to_];
  std::size_t next = options[uniformIndex(rng, options.size())];
  if (next == from_) next = options[uniformIndex(rng, options.size())];
  from_ = to_;
  to_ = next;
}

Vec2 Person::position(const Walkways& ways) const {
  const Vec2 link = ways.places[to_] - ways.places[from_];
  const double length = norm(link);
  if (length <= 0.0) return ways.places[from_];
  const Vec2 along = link * (1.0 / length);
  return ways.places[from_] + along * walked_ + leftOf(along) * sideways_;
}

}  // namespace place_memory::sim
