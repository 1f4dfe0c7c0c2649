#ifndef PLACE_MEMORY_EXPERIMENTS_METHOD_H
#define PLACE_MEMORY_EXPERIMENTS_METHOD_H

#include <string>
#include <vector>

#include "config/parameters.h"

namespace place_memory::experiments {

enum class Sensor { kSonar, kLaser };

/// A way to recognize places: its name in tables, and all it is made of.
struct Method {
  std::string name;
  std::string title;  ///< the name for people
  Sensor sensor = Sensor::kSonar;
  bool slow = false;  ///< run on the first seeds alone
  config::Parameters parameters;
};

/// The methods that are compared: those of the paper, and the default and what is left of it
/// without one part or with a laser. `default` is what the parameter files ask for on top of the
/// package's defaults; `preset`, where not empty, goes before theirs. Throws
/// config::ParameterError.
std::vector<Method> allMethods(const std::vector<std::string>& parameter_files,
                               const std::string& preset);

/// Those of `methods` with these names, in the order of the names; all of them for no names. Throws
/// std::runtime_error naming one that is unknown.
std::vector<Method> selectMethods(const std::vector<Method>& methods,
                                  const std::vector<std::string>& names);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_METHOD_H
