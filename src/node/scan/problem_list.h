#ifndef PLACE_MEMORY_NODE_SCAN_PROBLEM_LIST_H
#define PLACE_MEMORY_NODE_SCAN_PROBLEM_LIST_H

#include <map>
#include <string>
#include <utility>

namespace place_memory::node {

/// The newest sentence on each input that something is wrong with.
class ProblemList {
 public:
  void note(const std::string& input, const std::string& sentence) {
    if (sentences_.size() < kMost || sentences_.count(input) > 0) sentences_[input] = sentence;
  }

  bool empty() const { return sentences_.empty(); }
  void clear() { sentences_.clear(); }

  /// Joined by semicolons; empty where there is none.
  std::string inWords() const {
    std::string text;
    for (const auto& [input, sentence] : sentences_) text += (text.empty() ? "" : "; ") + sentence;
    return text;
  }

 private:
  static constexpr std::size_t kMost = 4;  // more than a person reads

  std::map<std::string, std::string> sentences_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_PROBLEM_LIST_H
