// SPDX-License-Identifier: MIT
// How is a drawing painted into pixels?
#pragma once
#include <span>

#include <games/frame/drawing.h>
#include <games/shell/cairo/font.h>
#include <games/shell/cairo/picture.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

struct PainterSettings {
    int threads = 1;     ///< each paints a band of the picture; the pixels are the same for any number
    bool quick = false;  ///< edges in 16 shades instead of 255, in three quarters of the time
};

/// Paints with Cairo, antialiased. One painter keeps its fonts for many drawings.
class Painter {
public:
    explicit Painter(const PainterSettings& settings = {}) : settings_(settings) {}

    /// Paints the whole drawing over the pixels. Throws std::runtime_error unless the sizes are the same.
    void paint(const Drawing& drawing, const PixelView& to) const;
    /// Paints some of its marks, in the given order.
    void paint(const Drawing& drawing, std::span<const Mark* const> marks, const PixelView& to) const;

    /// The box of a text [pixels]: from the baseline, or from the lowest point of its letters, to the highest point,
    /// and from the start of its first letter to the end of its last. For a turned text, the axis-aligned box around
    /// that.
    Aabb boxOf(const Mark& text) const;

private:
    PainterSettings settings_;
    Fonts fonts_;
};

}  // namespace plumb::games
