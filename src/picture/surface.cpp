#include "picture/surface.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "support/text.h"

namespace place_memory::picture {
namespace {

constexpr double kMeasured = 100.0;  // size of the font in which texts are measured

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("a picture cannot be drawn: ") +
                           cairo_status_to_string(status));
}

std::uint32_t toWord(const Color& color) {
  return (std::uint32_t{color.red} << 16U) | (std::uint32_t{color.green} << 8U) | color.blue;
}

cairo_status_t append(void* png, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(png)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Surface makeSurface(int width, int height, const Color& color) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return makeSurface(std::vector<Color>(count, color), width);
}

Surface makeSurface(const std::vector<Color>& pixels, int width) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t rows = pixels.size() / columns;
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, static_cast<int>(rows)));
  check(cairo_surface_status(surface.get()));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const std::uint32_t word = toWord(pixels[i]);
    std::memcpy(bytes + i / columns * stride + i % columns * sizeof word, &word, sizeof word);
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

std::string encodePng(cairo_surface_t& surface) {
  std::string png;
  check(cairo_surface_write_to_png_stream(&surface, append, &png));
  return png;
}

void chooseFont(cairo_t& context, double size) {
  cairo_select_font_face(&context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(&context, size);
}

double widthOf(const std::string& text, double size) {
  const Surface surface = makeSurface(1, 1, {});
  const Context context(cairo_create(surface.get()));
  chooseFont(*context, kMeasured);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), support::printable(text).c_str(), &extents);
  return extents.x_advance / kMeasured * size;
}

}  // namespace place_memory::picture
