#ifndef PLACE_MEMORY_CORE_SENSING_BASE_WATCH_H
#define PLACE_MEMORY_CORE_SENSING_BASE_WATCH_H

#include <optional>

namespace place_memory::core {

/// What a base makes of the rates that it is sent, as far as its yaw shows.
///
/// Angles in [rad], counter-clockwise; times in [s] of a clock that goes forward.
class BaseWatch {
 public:
  enum class Fault {
    kOtherWay,  ///< it turns against what is sent, said within half a second where that shows
    kStands,    ///< the top rate was sent for three seconds, and nothing came of it
  };

  /// `least_rate`: the base does not obey lower ones (its dead band); both > 0 [rad/s].
  BaseWatch(double least_rate, double max_rate) : least_rate_(least_rate), max_rate_(max_rate) {}

  /// `turned` is where the base is now; `rate` is what was sent to it since the update before.
  void update(double now, double turned, double rate);

  std::optional<Fault> fault() const { return fault_; }
  /// From the first rate that was sent to the first turn that was seen [s], in [0, 1]; 0 before.
  double lag() const { return lag_; }
  /// The least rate that the base is taken to obey: it rises while nothing comes of lower ones.
  double leastRate() const { return least_rate_; }

  /// The highest rate that was sent [rad/s], with its sign; 0: none was.
  double highestSent() const { return highest_sent_; }
  /// The way that a base would have turned which does as it is told.
  double sentWay() const { return sent_way_; }
  /// The way that it did turn, back and forth; noise of odometry counts little.
  double turnedWay() const { return turned_way_; }
  /// Since the first rate was sent.
  double turned() const { return started_ ? last_turned_ - first_turned_ : 0.0; }
  double seconds() const { return started_ ? last_time_ - first_time_ : 0.0; }

 private:
  void noteRest(double turned);
  void begin(double rate);
  void beginRun(double now, double turned, double rate);
  void judge(double now, double turned, double rate);
  bool leavesRestTheOtherWay(double now, double turned, double rate);

  double least_rate_;
  double max_rate_;
  std::optional<Fault> fault_;
  double lag_ = 0.0;

  bool started_ = false;
  bool has_moved_ = false;
  bool obeys_ = false;
  double first_time_ = 0.0;
  double first_turned_ = 0.0;
  double last_time_ = 0.0;
  double last_turned_ = 0.0;
  double highest_sent_ = 0.0;
  double sent_way_ = 0.0;
  double turned_way_ = 0.0;
  double way_mark_ = 0.0;  // up to which turned_way_ counts

  // Between which odometry showed it while nothing was sent.
  bool rested_ = false;
  double rest_low_ = 0.0;
  double rest_high_ = 0.0;
  std::optional<double> other_way_since_;  // it is beyond that, against what is sent

  // Of the time since the sign of the rate changed.
  bool first_run_ = true;
  double run_rate_ = 0.0;
  double run_from_ = 0.0;
  double run_best_ = 0.0;  // the furthest that it came the right way
  double progress_ = 0.0;  // when it last came further, or the rate was raised
  double at_top_ = 0.0;    // since when the top rate is sent and nothing comes of it
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_BASE_WATCH_H
