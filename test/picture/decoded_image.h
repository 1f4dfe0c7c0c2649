#ifndef PLACE_MEMORY_TEST_PICTURE_DECODED_IMAGE_H
#define PLACE_MEMORY_TEST_PICTURE_DECODED_IMAGE_H

#include <cairo/cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "picture/surface.h"

namespace place_memory::picture {

/// What a viewer sees of a PNG file.
class Image {
 public:
  explicit Image(const std::string& png) {
    std::string_view rest = png;
    surface_.reset(cairo_image_surface_create_from_png_stream(read, &rest));
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error("this is no PNG");
    }
  }

  std::size_t width() const {
    return static_cast<std::size_t>(cairo_image_surface_get_width(surface_.get()));
  }
  std::size_t height() const {
    return static_cast<std::size_t>(cairo_image_surface_get_height(surface_.get()));
  }
  /// Throws std::out_of_range.
  Color at(std::size_t column, std::size_t row) const {
    if (column >= width() || row >= height()) throw std::out_of_range("no such pixel");
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()));
    std::uint32_t word = 0;
    std::memcpy(&word,
                cairo_image_surface_get_data(surface_.get()) + row * stride + column * sizeof word,
                sizeof word);
    return {static_cast<std::uint8_t>(word >> 16U), static_cast<std::uint8_t>(word >> 8U),
            static_cast<std::uint8_t>(word)};
  }

 private:
  static cairo_status_t read(void* rest, unsigned char* bytes, unsigned int count) {
    auto& left = *static_cast<std::string_view*>(rest);
    if (left.size() < count) return CAIRO_STATUS_READ_ERROR;
    std::copy_n(left.begin(), count, bytes);
    left.remove_prefix(count);
    return CAIRO_STATUS_SUCCESS;
  }

  Surface surface_;
};

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_TEST_PICTURE_DECODED_IMAGE_H
