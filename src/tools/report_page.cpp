#include "tools/report_page.h"

#include <numeric>
#include <stdexcept>

#include "picture/grid_picture.h"
#include "picture/map_picture.h"
#include "picture/svg_text.h"

namespace place_memory::tools {
namespace {

using picture::decimal;
using picture::escaped;
using picture::mapPictures;
using picture::overlayPicture;
using picture::placePicture;
using picture::scanPicture;

// Totals and map are known last and read first: the page puts them there.
constexpr char kStyle[] = R"(
body { display: flex; flex-direction: column; font: 15px/1.4 sans-serif; margin: 1em auto;
  max-width: 64em; padding: 0 1em; color: #202020; }
header { order: -2; }
#summary { order: -1; }
section { border-top: 1px solid #c0c0c0; margin-top: 1em; }
figure { display: inline-block; margin: 0 1em 0 0; vertical-align: top; }
figcaption { font-size: 13px; color: #505050; max-width: 19em; }
svg.grid { width: 19em; height: 19em; border: 1px solid #808080; shape-rendering: crispEdges; }
svg.map { width: 100%; max-height: 36em; border: 1px solid #c0c0c0; }
table { border-collapse: collapse; }
td, th { padding: .1em .8em; text-align: left; border-bottom: 1px solid #e0e0e0; }
.recognized, .learned { color: #007000; }
.ambiguous { color: #906000; }
.failed { color: #b00000; }
)";

/// What came of an event, in a word; also its class in the style.
std::string kind(const ReportedEvent& event) {
  if (event.result.status != "ok") return "failed";
  return event.event.action == Action::kLearn ? "learned" : event.result.verdict;
}

std::string quoted(const std::string& label) { return "<b>" + escaped(label) + "</b>"; }

std::string inWords(const Result& result) {
  const std::string best =
      quoted(result.place) + " at a probability of " + decimal(result.probability, 3);
  if (result.verdict == core::nameOf(core::Verdict::kRecognized))
    return "RECOGNIZED: it is " + best;
  if (!result.matched) return "UNKNOWN: no place was learned yet";
  if (result.verdict == core::nameOf(core::Verdict::kAmbiguous)) {
    return "AMBIGUOUS: it is one of the places, but which is not sure; the best match is " + best;
  }
  return "UNKNOWN: no place is sure to fit; the best match is " + best;
}

std::string answer(const ReportedEvent& event) {
  const Result& result = event.result;
  if (result.status != "ok") return "no answer: " + escaped(result.status);
  if (event.event.action == Action::kLearn) return "learned as " + quoted(result.place);
  return inWords(result);
}

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string figure(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string robotInMap(const Result& result) {
  return "Robot in the map: x " + decimal(result.robot.x, 2) + " m, y " +
         decimal(result.robot.y, 2) + " m, yaw " + decimal(core::wrapAngle(result.robot.yaw), 3) +
         " rad.";
}

std::string pictures(const ReportedEvent& event) {
  if (!event.scan) return {};
  const core::Scan& scan = *event.scan;
  std::string text =
      figure(scanPicture(scan.grid, scan.robot_in_scan),
             "The scan, of " + std::to_string(scan.readings.size()) +
                 " readings. Black: occupied; white: empty; grey: unsensed. North is up, " +
                 decimal(2.0 * scan.grid.geometry().halfWidth(), 1) + " m across.");
  if (!event.place) return text;
  const Result& result = event.result;
  text += figure(placePicture(*event.place, result.place_from_scan, scan.robot_in_scan),
                 "Best match: " + quoted(result.place) + ", laid where it aligns.");
  text +=
      figure(overlayPicture(scan.grid, *event.place, result.place_from_scan, scan.robot_in_scan),
             "What is occupied: red in the scan, blue in the place, violet in both.");
  return text;
}

std::string runnersUp(const Result& result) {
  if (result.foremost.size() < 2) return {};
  std::string text = "<table><tr><th>place</th><th>probability</th><th>score</th></tr>\n";
  for (const Result::Ranked& match : result.foremost) {
    text += "<tr><td>" + escaped(match.label) + "</td><td>" + decimal(match.probability, 3) +
            "</td><td>" + decimal(match.score, 3) + "</td></tr>\n";
  }
  return text + "</table>\n";
}

}  // namespace

ReportPage::ReportPage(const std::string& path, const std::string& bags,
                       const std::vector<std::string>& notes)
    : path_(path), page_(path) {
  page_ << "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n<title>"
        << escaped(bags) << "</title>\n<style>" << kStyle << "</style></head>\n<body>\n"
        << "<header><h1>Places in " << escaped(bags) << "</h1>\n"
        << paragraph("Times are those of header stamps [s].");
  for (const std::string& note : notes) page_ << paragraph("Note: " + escaped(note));
  page_ << "</header>\n";
  page_.flush();
  if (!page_) throw std::runtime_error("cannot write the report " + path_);
}

void ReportPage::add(const ReportedEvent& event) {
  const Result& result = event.result;
  const std::string what = kind(event);
  ++totals_[what];
  page_ << "<section id=\"event" << event.number << "\">\n<h2>Event " << event.number
        << ": <span class=\"" << escaped(what) << "\">" << answer(event) << "</span></h2>\n"
        << paragraph(
               "From " + decimal(event.event.start.toSec(), 3) + " to " +
               decimal(event.event.end.toSec(), 3) + " s." +
               (result.status == "ok" && !result.place.empty() ? " " + robotInMap(result) : ""));
  if (!result.message.empty()) page_ << paragraph(escaped(result.message));
  if (!event.problem.empty()) page_ << paragraph("Inputs: " + escaped(event.problem));
  page_ << paragraph(event.left_out.empty() ? "No reading was left out."
                                            : "Readings left out: " + escaped(event.left_out) + ".")
        << pictures(event) << runnersUp(result) << "</section>\n";
  page_.flush();
}

void ReportPage::finish(const core::MapSnapshot& map, const core::FusedMap::GridOf& grid_of,
                        double cell_size) {
  const std::size_t events =
      std::accumulate(totals_.begin(), totals_.end(), std::size_t{0},
                      [](std::size_t sum, const auto& total) { return sum + total.second; });
  page_ << "<div id=\"summary\">\n<h2>Totals</h2>\n<table><tr><th>events</th><td>" << events
        << "</td></tr>\n";
  for (const auto& [what, count] : totals_) {
    page_ << "<tr><th class=\"" << escaped(what) << "\">" << escaped(what) << "</th><td>" << count
          << "</td></tr>\n";
  }
  page_ << "<tr><th>places in the map</th><td>" << map.places.size()
        << "</td></tr>\n<tr><th>links</th><td>" << map.links.size() << "</td></tr></table>\n"
        << "<h2>Map</h2>\n"
        << (map.places.empty() ? paragraph("It has no place.")
                               : mapPictures(map, grid_of, cell_size))
        << "</div>\n</body>\n</html>\n";
  page_.close();
  if (!page_) throw std::runtime_error("cannot write the report " + path_);
}

}  // namespace place_memory::tools
