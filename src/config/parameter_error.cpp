#include "place_memory/config/parameter_error.h"

#include <utility>

namespace place_memory::config {
namespace {

std::string joined(const std::vector<std::string>& problems) {
  std::string text = "parameters that cannot be used:";
  for (const std::string& problem : problems) text += "\n  " + problem;
  return text;
}

}  // namespace

ParameterError::ParameterError(std::vector<std::string> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

}  // namespace place_memory::config
