#ifndef PLACE_MEMORY_MAPPING_MAPPING_FIGURES_H
#define PLACE_MEMORY_MAPPING_MAPPING_FIGURES_H

#include <cstddef>
#include <vector>

#include "mapping/mapping_run.h"

namespace place_memory::mapping {

/// How near to the truth a run's poses and answers are.
struct MappingFigures {
  double way = 0.0;               ///< [m]
  double online = 0.0;            ///< absolute trajectory error as the robot knew it then, rms [m]
  double final = 0.0;             ///< likewise, as the map lies at the end [m]
  double final_scale_free = 0.0;  ///< that after the best scaling [m]
  std::size_t places = 0;
  std::size_t doubled = 0;     ///< pairs of places nearer than 0.6 m
  std::size_t false_ties = 0;  ///< ties in the final graph further off than 0.75 m or 20 degrees
  std::size_t answers = 0;     ///< that name a place older than 20 s
  std::size_t wrong = 0;       ///< of these, further off than 0.75 m or 20 degrees
  std::size_t again = 0;       ///< scans back at a place older than 20 s
  std::size_t known = 0;       ///< of these, that name such a one
  std::vector<double> errors;  ///< of the answers, sorted [m]
  double cpu = 0.0;            ///< [ms] by the metre

  double median() const { return errors.empty() ? 0.0 : errors[errors.size() / 2]; }
  double p99() const { return errors.empty() ? 0.0 : errors[errors.size() * 99 / 100]; }
};

/// `truth`: also of what made the mapper's map before this run.
MappingFigures figures(const core::Mapper& mapper, const MappingRun& run, const Truth& truth);

/// What P(lost) is worth, summed over runs.
class LostFigures {
 public:
  void add(const MappingRun& run);

  double way = 0.0;              ///< [m]
  std::size_t losses = 0;        ///< times that the robot was carried
  std::size_t said = 0;          ///< of these, within three scans that hold no reading from before
  std::size_t false_alarms = 0;  ///< times that P(lost) rose above .5 without need
  /// Mean distance of P(lost) from what was true, in ten bins, weighed by their scans.
  double calibrationError() const;

 private:
  struct Bin {
    double said = 0.0;
    double was = 0.0;
    std::size_t scans = 0;
  };
  std::vector<Bin> bins_ = std::vector<Bin>(10);
};

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_MAPPING_FIGURES_H
