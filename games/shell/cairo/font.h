// SPDX-License-Identifier: MIT
// How is a text written?
#pragma once
#include <array>

#include <games/frame/drawing.h>
#include <games/shell/cairo/surface.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

/// A line of text, made ready: glyphs from their start on the baseline, in pixels.
struct Glyphs {
    std::vector<cairo_glyph_t> glyphs;
    double width = 0;      ///< from the start of the first to the end of the last [pixels]
    double capHeight = 0;  ///< of a capital letter above the baseline [pixels]
    double size = 0;       ///< of the font [pixels]
};

/// Inter, or, where it is not installed, what fontconfig has instead.
class Fonts {
public:
    Fonts();

    /// Sets the font of a context that counts in pixels. Figures are all of one width, so that a number that counts
    /// does not jump. fitWidth: as TextStyle has it, in pixels.
    Glyphs set(cairo_t* context, const std::string& text, Weight weight, double size, double fitWidth) const;

private:
    std::array<CairoFace, 3> faces_;      ///< by weight
    std::array<double, 3> capHeights_{};  ///< of a font of size 1
};

}  // namespace plumb::games
