#include "core/map/change_words.h"

#include <cstddef>
#include <map>
#include <utility>
#include <variant>

namespace place_memory::core {
namespace {

/// Says how many there are of what takes one name, or the name.
std::string oneOrMany(const std::string& what, std::size_t count, const std::string& name,
                      const std::string& many) {
  return what + " " + (count == 1 ? "\"" + name + "\"" : std::to_string(count) + " " + many);
}

void append(std::string& words, const std::string& more) {
  words += (words.empty() ? "" : "; ") + more;
}

}  // namespace

std::string editsInWords(const std::vector<MapEdit>& edits, const PlaceMap& before) {
  const auto labelOf = [&before](PlaceId id) {
    const Place* place = before.find(id);
    return place == nullptr ? std::to_string(id) : place->label;
  };
  std::string words;
  std::map<std::string, std::pair<std::size_t, std::string>> counts;  // and the last name
  const auto count = [&counts](const char* kind, const std::string& name) {
    ++counts[kind].first;
    counts[kind].second = name;
  };
  for (const MapEdit& edit : edits) {
    if (const auto* added = std::get_if<PlaceAdded>(&edit)) {
      count("learned", added->place.label);
    } else if (const auto* removed = std::get_if<PlaceRemoved>(&edit)) {
      count("removed", labelOf(removed->id));
    } else if (const auto* renamed = std::get_if<PlaceRenamed>(&edit)) {
      append(words, "renamed \"" + labelOf(renamed->id) + "\" to \"" + renamed->label + "\"");
    } else if (const auto* moved = std::get_if<PlaceMoved>(&edit)) {
      count("moved", labelOf(moved->id));
    } else if (const auto* adapted = std::get_if<GridAdapted>(&edit)) {
      count("folded a scan into", labelOf(adapted->id));
    } else if (const auto* link = std::get_if<LinkAdded>(&edit)) {
      const bool is_new =
          before.find(link->link.first) != nullptr && before.find(link->link.second) != nullptr;
      if (is_new)
        count("linked", labelOf(link->link.first) + "\" to \"" + labelOf(link->link.second));
    } else if (const auto* set = std::get_if<LinkLearned>(&edit)) {
      if (!set->traversal)
        count("set the link", labelOf(set->from) + "\" to \"" + labelOf(set->to));
    } else if (const auto* cut = std::get_if<LinkRemoved>(&edit)) {
      count("unlinked", labelOf(cut->first) + "\" from \"" + labelOf(cut->second));
    } else if (std::holds_alternative<MapCleared>(edit)) {
      append(words, "removed all " + std::to_string(before.size()) + " places");
    }
  }
  for (const auto& [kind, number_and_name] : counts) {
    const bool of_links = kind == "linked" || kind == "unlinked" || kind == "set the link";
    append(words, oneOrMany(kind, number_and_name.first, number_and_name.second,
                            of_links ? "pairs of places" : "places"));
  }
  return words;
}

}  // namespace place_memory::core
