// Looks at maps and changes them, in a store's file or in a node that runs.
#include <cstdlib>
#include <exception>
#include <iostream>

#include "tools/map_arguments.h"
#include "tools/map_commands.h"

int main(int argc, char** argv) {
  namespace tools = place_memory::tools;
  try {
    const auto arguments = tools::readMapArguments(argc, argv, std::cout);
    return arguments ? tools::runCommand(*arguments, std::cout, std::cerr) : EXIT_SUCCESS;
  } catch (const tools::CommandError& error) {
    std::cerr << "place_memory: " << error.what() << '\n';
    return error.status();
  } catch (const std::exception& error) {
    std::cerr << "place_memory: " << error.what() << '\n';
    return tools::kFailed;
  }
}
