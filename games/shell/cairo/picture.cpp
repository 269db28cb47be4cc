// SPDX-License-Identifier: MIT
#include <games/shell/cairo/picture.h>

#include <games/shell/cairo/surface.h>
#include <stdexcept>

namespace plumb::games {
namespace {

void require(cairo_status_t status, const std::string& doing) {
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(doing + ": " + cairo_status_to_string(status));
}

}  // namespace

CairoSurface surfaceOf(const PixelView& picture) {
    auto* bytes = reinterpret_cast<unsigned char*>(picture.pixels);
    CairoSurface surface(cairo_image_surface_create_for_data(bytes, CAIRO_FORMAT_ARGB32, picture.size.width,
                                                             picture.size.height, picture.stride));
    require(cairo_surface_status(surface.get()), "a picture of " + std::to_string(picture.size.width) + " x " +
                                                     std::to_string(picture.size.height) + " pixels");
    return surface;
}

void writePng(const PixelView& picture, const std::string& file) {
    require(cairo_surface_write_to_png(surfaceOf(picture).get(), file.c_str()), file);
}

}  // namespace plumb::games
