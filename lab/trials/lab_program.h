#ifndef PLACE_MEMORY_LAB_TRIALS_LAB_PROGRAM_H
#define PLACE_MEMORY_LAB_TRIALS_LAB_PROGRAM_H

#include <boost/program_options.hpp>
#include <exception>
#include <functional>
#include <iostream>
#include <string>

namespace place_memory::trials {

/// Reads a command line, shows the options to who asks with --help, and runs the program with what
/// was given. Returns the program's exit status: `run`'s, or 1 where something is wrong, which is
/// said in a sentence under `name`.
inline int runProgram(
    const std::string& name, int argc, char** argv,
    const boost::program_options::options_description& options,
    const std::function<int(const boost::program_options::variables_map&)>& run,
    const boost::program_options::positional_options_description& positions = {}) {
  namespace po = boost::program_options;
  try {
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(options).positional(positions).run(),
              given);
    if (given.count("help") > 0) {
      std::cout << options;
      return 0;
    }
    po::notify(given);
    return run(given);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
}

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_LAB_TRIALS_LAB_PROGRAM_H
