#include "config/yaml_file.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "place_memory/config/parameter_error.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

// yaml-cpp before 0.7 nests without bound; no parameter lies deeper than three tables.
constexpr std::size_t kMostBrackets = 1000;
constexpr std::size_t kMostBlanks = 1000;

// YAML forbids tabs there; yaml-cpp takes some of them for blanks.
void refuseTabs(const std::string& text) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t content = line.find_first_not_of(" \t\r");
    if (content == std::string::npos || line[content] == '#') continue;
    if (line.find('\t') < content) {
      throw std::runtime_error("line " + std::to_string(number) +
                               ": begins with a tab; YAML needs blanks there");
    }
    if (content > kMostBlanks) {
      throw std::runtime_error("line " + std::to_string(number) + ": lies too deep");
    }
  }
}

void refuseDepth(const std::string& text) {
  const auto brackets =
      std::count_if(text.begin(), text.end(), [](char c) { return c == '[' || c == '{'; });
  if (static_cast<std::size_t>(brackets) > kMostBrackets) {
    throw std::runtime_error("has more lists and tables than any parameters need");
  }
}

YAML::Node parse(const std::string& text) {
  refuseTabs(text);
  refuseDepth(text);
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  if (documents.size() > 1) {
    throw std::runtime_error("holds " + std::to_string(documents.size()) +
                             " YAML documents, divided by ---; write them as one");
  }
  return documents.empty() ? YAML::Node() : documents.front();
}

}  // namespace

YAML::Node loadYamlText(const std::string& bytes, const std::string& source) {
  try {
    return parse(support::decodedText(bytes));
  } catch (const YAML::Exception& error) {
    throw ParameterError({source + ", line " + std::to_string(error.mark.line + 1) + ", column " +
                          std::to_string(error.mark.column + 1) + ": is no YAML: " + error.msg});
  } catch (const std::runtime_error& error) {
    throw ParameterError({source + ": " + error.what()});
  }
}

YAML::Node loadYamlFile(const std::string& path) {
  std::string bytes;
  try {
    bytes = support::readWholeFile(path);
  } catch (const std::runtime_error& error) {
    throw ParameterError({error.what()});
  }
  return loadYamlText(bytes, path);
}

}  // namespace place_memory::config
