// SPDX-License-Identifier: MIT
// How does Cairo draw into existing pixels?
#pragma once
#include <cairo.h>

#include <games/shell/cairo/picture.h>
#include <memory>

namespace plumb::games {

template <auto destroy>
struct Destroy {
    template <class T>
    void operator()(T* thing) const {
        destroy(thing);
    }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;
using CairoPattern = std::unique_ptr<cairo_pattern_t, Destroy<cairo_pattern_destroy>>;
using CairoFace = std::unique_ptr<cairo_font_face_t, Destroy<cairo_font_face_destroy>>;

/// Throws std::runtime_error when Cairo does not accept the picture.
CairoSurface surfaceOf(const PixelView& picture);

}  // namespace plumb::games
