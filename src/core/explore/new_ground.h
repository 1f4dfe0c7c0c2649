#ifndef PLACE_MEMORY_CORE_EXPLORE_NEW_GROUND_H
#define PLACE_MEMORY_CORE_EXPLORE_NEW_GROUND_H

namespace place_memory::core {

/// How long a robot that explores drives on without coming to new ground before it gives up.
struct PatienceOptions {
  double least = 20.0;   ///< it drives so far at the least [m], > 0
  double share = 0.5;    ///< and as this share of the way before, >= 0
  double growth = 0.05;  ///< by this share the ground it came to must have grown, > 0
};

/// Whether what a robot drives still leads it to new ground. An echo that was mirrored, or that
/// came from the edge of a door, leaves openings on the map that lead nowhere: of a building that
/// is all seen there are always some more to be tried.
class NewGround {
 public:
  explicit NewGround(const PatienceOptions& options) : options_(options) {}

  /// `way` driven until now [m], not falling, and the area about it where the robot was near by
  /// [m^2].
  void note(double way, double area);
  /// It was driven for too long since that area grew last.
  bool isInVain(double way) const;
  /// Where on its way it did [m].
  double grewAt() const { return way_; }

 private:
  PatienceOptions options_;
  double way_ = 0.0;
  double area_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_NEW_GROUND_H
