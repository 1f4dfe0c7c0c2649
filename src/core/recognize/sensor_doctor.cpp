#include "core/recognize/sensor_doctor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/recognize/grid_view.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

constexpr double kOffset = 3.0 * kPi / 180.0;  // between axes that are tried [rad]
constexpr std::size_t kFewestScans = 3;
constexpr std::size_t kFewestReadings = 10;
constexpr std::size_t kFewestEchoes = 3;  // in a scan, to turn an axis by
constexpr double kShort = 0.3;            // [m] nearer than the grid is known to be empty
constexpr double kAlways = 0.8;
constexpr double kBlockedSpread = 0.15;  // [m]
constexpr double kOftenShort = 0.065;
constexpr double kFewestShorts = 7.0;
constexpr double kCoincide = 0.8;  // of short ranges
constexpr double kAlone = 0.75;    // of how often the one was heard, no other was more often
constexpr double kAlike = 0.03;    // [m], and one part in a hundred
constexpr double kLeastTurn = 11.0 * kPi / 180.0;
constexpr double kLeastSigma = kPi / 180.0;
constexpr double kSure = 5.5;    // sigmas of an estimate of many sensors
constexpr double kBetter = 1.5;  // sigmas by which it fits better
constexpr int kMostEvidence = 40;
constexpr int kLeastEvidence = -20;

bool alike(double a, double b) { return std::abs(a - b) <= kAlike + 0.01 * a; }

double quantile(std::vector<double> values, double share) {
  const auto nth = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + nth, values.end());
  return values[static_cast<std::size_t>(nth)];
}

// The offset at the peak, between those that were tried.
double peak(const std::vector<double>& fit) {
  const auto best = std::max_element(fit.begin(), fit.end());
  const double i = static_cast<double>(best - fit.begin());
  double between = 0.0;
  if (best != fit.begin() && best + 1 != fit.end()) {
    const double bend = *(best - 1) - 2.0 * *best + *(best + 1);
    if (bend < 0.0) between = 0.5 * (*(best - 1) - *(best + 1)) / bend;
  }
  return kOffset * (i + between - 0.5 * static_cast<double>(fit.size() - 1));
}

// Sensors that heard the same distance at about the same time, in the same round of the ring, and
// where the grid has something: what is short for both is a thing that came.
std::set<std::uint32_t> whoHeardTheSame(const Scan& scan, const std::vector<bool>& is_short,
                                        std::size_t reading) {
  std::set<std::uint32_t> before{scan.sensors[reading]};
  std::set<std::uint32_t> after = before;
  std::set<std::uint32_t> same;
  const double range = scan.readings[reading].range;
  const auto look = [&](std::size_t i, std::set<std::uint32_t>& seen) {
    if (!seen.insert(scan.sensors[i]).second) return;
    if (!is_short[i] && std::isfinite(scan.readings[i].range) &&
        alike(range, scan.readings[i].range)) {
      same.insert(scan.sensors[i]);
    }
  };
  constexpr std::size_t kRound = 32;  // [readings]
  for (std::size_t off = 1; off <= kRound; ++off) {
    if (off <= reading) look(reading - off, before);
    if (reading + off < scan.readings.size()) look(reading + off, after);
  }
  return same;
}

}  // namespace

void SensorDoctor::examine(const Scan& scan, const EvidenceGrid& place,
                           const Pose2d& place_from_scan) {
  if (scan.sensors.size() != scan.readings.size()) return;
  const std::vector<SonarReading> readings = movedReadings(scan.readings, place_from_scan);
  std::vector<bool> is_short(readings.size());
  Sensors sensors;
  std::map<std::uint32_t, std::vector<SonarReading>> by_sensor;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const SonarReading& reading = readings[i];
    Findings& findings = sensors[scan.sensors[i]];
    by_sensor[scan.sensors[i]].push_back(reading);
    const GridView view = viewFrom(place, reading.sensor_pose, reading.spec);
    const bool echo = std::isfinite(reading.range);
    ++findings.readings;
    if (echo) ++findings.echoes;
    if (view.echo && *view.echo < 0.8 * reading.spec.max_range) ++findings.due;
    if (echo) findings.ranges.push_back(reading.range);
    is_short[i] = echo && reading.range < view.clear - kShort;
    if (is_short[i]) findings.shorts.push_back(reading.range);
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!is_short[i]) continue;
    Findings& findings = sensors[scan.sensors[i]];
    for (const std::uint32_t other : whoHeardTheSame(scan, is_short, i)) ++findings.like[other];
  }
  for (auto& [sensor, findings] : sensors) findings.fit = fitTurned(by_sensor[sensor], place);
  scans_.push_back(std::move(sensors));
  if (scans_.size() > kMostScans) scans_.pop_front();
}

std::vector<double> SensorDoctor::fitTurned(const std::vector<SonarReading>& readings,
                                            const EvidenceGrid& place) const {
  const auto echoes = std::count_if(readings.begin(), readings.end(),
                                    [](const SonarReading& r) { return std::isfinite(r.range); });
  if (static_cast<std::size_t>(echoes) < kFewestEchoes) return {};
  std::vector<double> fit;
  for (int offset = 0; offset < kOffsets; ++offset) {
    std::vector<SonarReading> turned = readings;
    for (SonarReading& reading : turned) {
      reading.sensor_pose.yaw += kOffset * (offset - kOffsets / 2);
    }
    const EvidenceGrid own = model_.build(turned, place.geometry());
    double sum = 0.0;
    for (std::size_t cell = 0; cell < own.cells().size(); ++cell) {
      sum +=
          own.cells()[cell] * std::clamp<int>(place.cells()[cell], kLeastEvidence, kMostEvidence);
    }
    fit.push_back(sum / static_cast<double>(readings.size()));
  }
  return fit;
}

std::vector<SensorDiagnosis> SensorDoctor::diagnose() const {
  std::set<std::uint32_t> numbers;
  for (const Sensors& sensors : scans_) {
    for (const auto& [number, findings] : sensors) numbers.insert(number);
  }
  std::vector<SensorDiagnosis> diagnoses;
  std::vector<double> turns;
  for (const std::uint32_t number : numbers) {
    diagnoses.push_back(diagnose(number));
    const Turned turned = turnOf(number);
    if (turned.uncertainty > 0.0) turns.push_back(turned.by);
  }
  // A compass that is off turns all of them alike.
  const double common = turns.size() >= 4 ? quantile(turns, 0.5) : 0.0;
  for (SensorDiagnosis& diagnosis : diagnoses) {
    const Turned turned = turnOf(diagnosis.sensor);
    if (turned.uncertainty == 0.0) continue;
    diagnosis.yaw_error = turned.by - common;
    diagnosis.uncertainty = turned.uncertainty;
    const double least = std::max(kLeastTurn, kSure * turned.uncertainty);
    if (diagnosis.fault == SensorFault::kNone && turned.is_sure &&
        std::abs(diagnosis.yaw_error) >= least) {
      diagnosis.fault = SensorFault::kMountedOff;
    }
  }
  return diagnoses;
}

bool SensorDoctor::isDead(std::uint32_t sensor) const {
  if (scans_.size() < kFewestScans) return false;
  return std::none_of(scans_.end() - 2, scans_.end(),
                      [&](const Sensors& sensors) { return sensors.count(sensor) > 0; });
}

SensorDiagnosis SensorDoctor::diagnose(std::uint32_t sensor) const {
  Findings all;
  for (const Sensors& sensors : scans_) {
    const auto found = sensors.find(sensor);
    if (found == sensors.end()) continue;
    const Findings& f = found->second;
    all.readings += f.readings;
    all.echoes += f.echoes;
    all.due += f.due;
    all.ranges.insert(all.ranges.end(), f.ranges.begin(), f.ranges.end());
    all.shorts.insert(all.shorts.end(), f.shorts.begin(), f.shorts.end());
    for (const auto& [other, count] : f.like) all.like[other] += count;
  }
  SensorDiagnosis diagnosis;
  diagnosis.sensor = sensor;
  diagnosis.readings = all.readings;
  if (isDead(sensor)) diagnosis.fault = SensorFault::kDead;
  if (diagnosis.fault != SensorFault::kNone || scans_.size() < kFewestScans ||
      all.readings < kFewestReadings) {
    return diagnosis;
  }
  const auto shorts = static_cast<double>(all.shorts.size());
  const auto readings = static_cast<double>(all.readings);
  if (all.echoes == 0 && all.due >= kFewestReadings) {
    diagnosis.fault = SensorFault::kNeverHears;
  } else if (shorts >= kFewestShorts && static_cast<double>(all.echoes) >= kAlways * readings &&
             quantile(all.ranges, 0.9) - quantile(all.ranges, 0.1) < kBlockedSpread) {
    diagnosis.fault = SensorFault::kBlocked;
    diagnosis.range = quantile(all.ranges, 0.5);
  } else if (shorts >= std::max(kOftenShort * readings, kFewestShorts) && !all.like.empty()) {
    const auto most =
        std::max_element(all.like.begin(), all.like.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    std::size_t second = 0;
    for (const auto& [other, count] : all.like) {
      if (other != most->first) second = std::max(second, count);
    }
    // Where several heard the same, they see one wall.
    if (static_cast<double>(most->second) >= kCoincide * shorts &&
        static_cast<double>(second) < kAlone * static_cast<double>(most->second)) {
      diagnosis.fault = SensorFault::kCrosstalk;
      diagnosis.other = most->first;
    }
  }
  return diagnosis;
}

SensorDoctor::Turned SensorDoctor::turnOf(std::uint32_t sensor) const {
  std::vector<const std::vector<double>*> fits;
  for (const Sensors& sensors : scans_) {
    const auto found = sensors.find(sensor);
    if (found != sensors.end() && !found->second.fit.empty()) fits.push_back(&found->second.fit);
  }
  Turned turned;
  if (fits.size() < kFewestScans) return turned;
  std::vector<double> sum(kOffsets, 0.0);
  for (const auto* fit : fits) {
    std::transform(sum.begin(), sum.end(), fit->begin(), sum.begin(), std::plus<>());
  }
  turned.by = peak(sum);
  // By leaving out one scan after the other.
  const auto n = static_cast<double>(fits.size());
  double variance = 0.0;
  for (const auto* fit : fits) {
    std::vector<double> rest = sum;
    std::transform(rest.begin(), rest.end(), fit->begin(), rest.begin(), std::minus<>());
    const double off = peak(rest) - turned.by;
    variance += (n - 1.0) / n * off * off;
  }
  turned.uncertainty = std::max(std::sqrt(variance), kLeastSigma);
  // How much better it fits than as it is mounted, scan by scan.
  const auto best =
      static_cast<std::size_t>(std::max_element(sum.begin(), sum.end()) - sum.begin());
  double gain = 0.0;
  double square = 0.0;
  for (const auto* fit : fits) {
    const double better = (*fit)[best] - (*fit)[kOffsets / 2];
    gain += better / n;
    square += better * better / n;
  }
  const double sigma = std::sqrt(std::max(square - gain * gain, 0.0) / (n - 1.0));
  turned.is_sure = best > 0 && best + 1 < sum.size() && gain > kBetter * sigma && gain > 0.0;
  return turned;
}

}  // namespace place_memory::core
