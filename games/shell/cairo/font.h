// SPDX-License-Identifier: MIT
// How is a line of text set in a font?
#pragma once
#include <array>

#include <games/frame/drawing.h>
#include <games/shell/cairo/surface.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

/// A line of text, ready to be drawn: glyphs at positions from the start of the baseline, in pixels.
struct Glyphs {
    std::vector<cairo_glyph_t> glyphs;
    double width = 0;      ///< from the start of the first to the end of the last [pixels]
    double capHeight = 0;  ///< of a capital letter above the baseline [pixels]
    double size = 0;       ///< of the font [pixels]
};

/// The font Inter, or the one that fontconfig gives instead if Inter is not installed.
class Fonts {
public:
    Fonts();

    /// Sets the font of a context whose unit is the pixel. All digits have the same width, so that a number does not
    /// jump when it changes. fitWidth: as in TextStyle, but in pixels.
    Glyphs set(cairo_t* context, const std::string& text, Weight weight, double size, double fitWidth) const;

private:
    std::array<CairoFace, 3> faces_;      ///< by weight
    std::array<double, 3> capHeights_{};  ///< of a font of size 1
};

}  // namespace plumb::games
