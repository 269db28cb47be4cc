// SPDX-License-Identifier: MIT
// How are pictures that follow one another painted in less time?
#pragma once
#include <games/shell/cairo/painter.h>

namespace plumb::games {

/// Paints drawings that begin by filling the window, with the same pixels as Painter. The first marks of a drawing that
/// are the same as in the drawings before it are painted once and kept: a background that stands still costs only a
/// copy.
class KeptPainter {
public:
    explicit KeptPainter(const PainterSettings& settings = {}) : painter_(settings) {}

    /// Throws like Painter::paint.
    void paint(const Drawing& drawing, const PixelView& to);

private:
    using Marks = std::vector<const Mark*>;
    /// The picture of the first marks of a drawing.
    struct Beginning {
        Picture picture{{1, 1}};
        std::size_t marks = 0;
    };
    void keep(const Marks& marks, const Drawing& drawing, std::size_t same);
    void extend(const Marks& marks, const Drawing& drawing, std::size_t to);

    Painter painter_;
    Drawing last_;
    Marks lastMarks_;               ///< of last_, in their order
    Beginning kept_;                ///< the marks that the last two drawings have in common
    std::vector<Beginning> steps_;  ///< shorter ones, for drawings that have less in common; the longest last
};

}  // namespace plumb::games
