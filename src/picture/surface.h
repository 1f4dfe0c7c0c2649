#ifndef PLACE_MEMORY_PICTURE_SURFACE_H
#define PLACE_MEMORY_PICTURE_SURFACE_H

#include <cairo/cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "picture/picture.h"

namespace place_memory::picture {

struct CairoDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using Surface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using Context = std::unique_ptr<cairo_t, CairoDeleter>;

/// An image of one colour. Throws std::runtime_error where there is no memory for it.
Surface makeSurface(int width, int height, const Color& color);

/// Row by row from the top, `width` pixels each. Throws likewise.
Surface makeSurface(const std::vector<Color>& pixels, int width);

/// The bytes of a PNG file. Throws std::runtime_error where something was drawn in vain.
std::string encodePng(cairo_surface_t& surface);

/// For text.
void chooseFont(cairo_t& context, double size);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_SURFACE_H
