// SPDX-License-Identifier: MIT
// How does a drawing come to be pixels?
#pragma once
#include <span>

#include <games/frame/drawing.h>
#include <games/shell/cairo/font.h>
#include <games/shell/cairo/picture.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

struct PainterSettings {
    int threads = 1;     ///< at once, each for a band of the picture; the pixels are the same
    bool quick = false;  ///< edges in 16 shades, not 255, in three quarters of the time
};

/// Paints with Cairo, antialiased. One painter keeps its fonts for many drawings.
class Painter {
public:
    explicit Painter(const PainterSettings& settings = {}) : settings_(settings) {}

    /// All of the drawing, over what is there. Throws std::runtime_error unless the sizes are the same.
    void paint(const Drawing& drawing, const PixelView& to) const;
    /// Some of its marks, as they come.
    void paint(const Drawing& drawing, std::span<const Mark* const> marks, const PixelView& to) const;

    /// Where a text comes to lie: from the baseline, or from the lowest that its letters reach, to the highest, and
    /// from the start of its first letter to the end of its last; around it, if it is turned [pixels].
    Aabb boxOf(const Mark& text) const;

private:
    PainterSettings settings_;
    Fonts fonts_;
};

}  // namespace plumb::games
