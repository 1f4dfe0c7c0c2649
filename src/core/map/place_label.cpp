#include "core/map/place_label.h"

#include <boost/locale/utf.hpp>

namespace place_memory::core {

bool isValidLabel(std::string_view label) {
  namespace utf = boost::locale::utf;
  if (label.empty() || label.size() > kMaxLabelBytes) return false;
  if (label.find_first_not_of(' ') == std::string_view::npos) return false;
  for (auto at = label.begin(); at != label.end();) {
    const utf::code_point point = utf::utf_traits<char>::decode(at, label.end());
    if (!utf::is_valid_codepoint(point)) return false;
    const bool is_control = point < 0x20 || (point >= 0x7f && point < 0xa0);
    if (is_control) return false;
  }
  return true;
}

}  // namespace place_memory::core
