#ifndef PLACE_MEMORY_CONFIG_PARAMETER_ERROR_H
#define PLACE_MEMORY_CONFIG_PARAMETER_ERROR_H

#include <stdexcept>
#include <string>
#include <vector>

#include "place_memory/export.h"

namespace place_memory::config {

/// Parameters that cannot be used: one line for each problem.
class PLACE_MEMORY_PUBLIC ParameterError : public std::runtime_error {
 public:
  explicit ParameterError(std::vector<std::string> problems);

  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::vector<std::string> problems_;
};

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_PARAMETER_ERROR_H
