#include <gtest/gtest.h>

#include <ostream>

#include "config/parsed_parameters.h"

namespace place_memory::config {
namespace {

struct Malformed {
  const char* text;
  const char* problem;  // part of it
};

std::ostream& operator<<(std::ostream& out, const Malformed& m) { return out << m.text; }

class MalformedParameter : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedParameter, IsNamedWithWhatIsWrong) {
  const auto problems = problemsOf(GetParam().text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find(GetParam().problem), std::string::npos) << problems[0];
}

INSTANTIATE_TEST_SUITE_P(
    LoadParameters, MalformedParameter,
    testing::Values(
        Malformed{"[1, 2]", "must be a table of parameters, not a list"},
        Malformed{"cell_size: 0.1", "cell_size (test): is not a parameter"},
        Malformed{"grid: {size: 64}", "grid/size (test): is not a parameter"},
        Malformed{"grid: 0.1", "grid (test): is a table of parameters, not '0.1'"},
        Malformed{"grid: {cell_size: {x: 1}}", "grid/cell_size/x (test): is not a parameter"},
        Malformed{"grid: {cell_size: 0.1, cell_size: 0.2}",
                  "grid/cell_size (test): is given twice"},
        Malformed{"grid: {cell_size: small}", "must be a number, not 'small'"},
        Malformed{"grid: {cell_size: \"0.1\"}", "must be a number, not '0.1'"},
        Malformed{"grid: {cell_size: [0.1]}", "must be a number, not a list"},
        Malformed{"grid: {cell_size: }", "must be a number, not nothing"},
        Malformed{"grid: {cell_size: .nan}", "must be in [0.001, 100], not '.nan'"},
        Malformed{"grid: {cell_size: .inf}", "must be in [0.001, 100], not '.inf'"},
        Malformed{"grid: {cell_size: 0}", "must be in [0.001, 100], not '0'"},
        Malformed{"sonar: {prior: 0}", "must be in (0, 1)"},
        Malformed{"sonar: {prior: 0.8}", "sonar: must be ascending"},
        Malformed{"sonar: {occupied: 1}", "must be in (0, 1)"},
        Malformed{"sonar: {empty: 0.5}", "sonar: must be ascending"},
        Malformed{"sonar: {echo_depth: 0.4}", "must be in [0.5, 8]"},
        Malformed{"scan: {headings: -1}", "must be in [0, 3600]"},
        Malformed{"scan: {headings: 3601}", "must be in [0, 3600]"},
        Malformed{"scan: {headings: 2.5}", "must be a whole number, not '2.5'"},
        Malformed{"scan: {step: 0.0}", "must be in [0.001, 3.14159]"},
        Malformed{"scan: {step: 3.2}", "must be in [0.001, 3.14159]"},
        Malformed{"scan: {turn: left}", "must be one of listen, cmd_vel, not 'left'"},
        Malformed{"scan: {turn: true}", "must be a text, not 'true'"},
        Malformed{"scan: {turn_rate: -0.2}", "must be in (0, 3.14159]"},
        Malformed{"scan: {timeout: 0}", "must be in (0, 3600]"},
        Malformed{"scan: {min_readings: 0}", "must be in [1, 100000]"},
        Malformed{"scan: {tf_timeout: -0.1}", "must be in [0, 10]"},
        Malformed{"scan: {heading_timeout: 0}", "must be in (0, 3600]"},
        Malformed{"scan: {over_range_is_no_echo: 1}", "must be true or false, not '1'"},
        Malformed{"match: {preset: /no/such/file}", "must be evidence, paper or the path"},
        Malformed{"match: {preset: 1}", "must be a text"},
        Malformed{"match: {method: guess}", "must be one of nearest_neighbour, hill_climbing"},
        Malformed{"match: {position_window: 0}", "must be in (0, 100]"},
        Malformed{"match: {heading_window: 3.2}", "must be in [0, 3.14159]"},
        Malformed{"match: {confidence: 0.5}", "must be in (0.5, 1)"},
        Malformed{"match: {threads: -1}", "must be in [0, 256]"},
        Malformed{"match: {threads: 257}", "must be in [0, 256]"},
        Malformed{"match: {threads: 1.5}", "must be a whole number"},
        Malformed{"places: {adapt: 1}", "must be true or false, not '1'"},
        Malformed{"places: {retention: 1}", "must be in [0, 1)"},
        Malformed{"places: {retention: -0.1}", "must be in [0, 1)"},
        Malformed{"base_frame: ''", "must not be empty"},
        Malformed{"base_frame: /", "must not be empty"},
        Malformed{"odom_frame: base_link", "must not be the same frame"},
        Malformed{"map_frame: 5", "must be a text, not '5'"},
        Malformed{"sonar_topics: sonar", "must be a list of one text or more"},
        Malformed{"sonar_topics: []", "must be a list of one text or more"},
        Malformed{"sonar_topics: [sonar, 5]", "must be a list of texts"},
        Malformed{"sonar_topics: [so nar]", "must consist of letters"},
        Malformed{"sonar_topics: ['']", "must not be empty"},
        Malformed{"heading_topic: 0heading", "must begin with a letter"},
        Malformed{"heading_topic: ~heading", "must begin with a letter"},
        Malformed{"sonar_topics: [sonar, sonar]", "a topic is given twice"},
        Malformed{"{odom_frame: '', heading_topic: ''}", "must not both be empty"},
        Malformed{"{odom_frame: '', odom_topic: odom}", "odom_topic: needs an odom_frame"},
        Malformed{"heading_topic: sonar", "sonar is given twice"},
        Malformed{"cloud: {mounts: [[0, 0]]}", "each must be [x, y, yaw]"},
        Malformed{"cloud: {mounts: [[0, 0, north]]}", "each must be [x, y, yaw]"},
        Malformed{"cloud: {mounts: [[0, 0, .nan]]}", "each must be [x, y, yaw]"},
        Malformed{"cloud: {mounts: 5}", "must be a list of up to 64 poses"},
        Malformed{"cloud: {max_range: 0}", "must be in (0, 100]"},
        Malformed{"laser: {cones: 0}", "must be in [1, 200]"},
        Malformed{"heading: {declination: 5}", "must be in [-3.14159, 3.14159]"},
        Malformed{"heading: {reversed: 1}", "must be true or false"},
        Malformed{"sonar: {top_is_no_echo: 1}", "must be true or false"},
        Malformed{"store: [a]", "must be a text, not a list"},
        Malformed{"map_frame: 2020-01-31", "must be a text, not the date '2020-01-31'"},
        Malformed{"map_frame: deg(2)", "must be a text, not 'deg(2)'"},
        Malformed{"map_frame: no", "must be a text, not 'no'"},
        Malformed{"map_frame: !!binary aGk=", "must be a text, not binary data"},
        Malformed{"map_frame: !kind map", "must be a text, not a value tagged !kind"},
        Malformed{"map_frame: .nan", "must be a text, not '.nan'"},
        Malformed{"base_frame: \"base\\nlink\"", "must not hold line breaks"},
        Malformed{"base_frame: \"base\\0link\"", "must not hold line breaks"},
        Malformed{"odom_frame: ' '", "must not begin or end with a blank"},
        Malformed{"base_frame: 'base_link '", "must not begin or end with a blank"},
        Malformed{"scan: {step: deg(two)}", "must be a number, not 'deg(two)'"},
        Malformed{"scan: {heading: 5}", "is not a parameter; is scan/headings meant?"},
        Malformed{"place_memory: {scan: {headings: 5}}", "is scan/headings meant?"},
        Malformed{"colour: red", "colour (test): is not a parameter"},
        Malformed{"grid: {cell_size: 1, 03}", "decimals have a point, not a comma"},
        Malformed{"<<: 5", "<< (test): must be a table, not '5'"},
        Malformed{"? [a]\n: 5", "a name must be a text, not a list"}));

}  // namespace
}  // namespace place_memory::config
