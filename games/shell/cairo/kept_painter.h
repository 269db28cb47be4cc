// SPDX-License-Identifier: MIT
// How is one picture after another painted in less time?
#pragma once
#include <games/shell/cairo/painter.h>

namespace plumb::games {

/// Paints as Painter does, to the same pixels, drawings that begin by filling the window. What a drawing has in common
/// with those before it, from its first mark on, is painted once and kept: a still background costs a copy.
class KeptPainter {
public:
    explicit KeptPainter(const PainterSettings& settings = {}) : painter_(settings) {}

    /// Throws as Painter::paint does.
    void paint(const Drawing& drawing, const PixelView& to);

private:
    using Marks = std::vector<const Mark*>;
    /// What the first marks of a drawing come to.
    struct Beginning {
        Picture picture{{1, 1}};
        std::size_t marks = 0;
    };
    void keep(const Marks& marks, const Drawing& drawing, std::size_t same);
    void extend(const Marks& marks, const Drawing& drawing, std::size_t to);

    Painter painter_;
    Drawing last_;
    Marks lastMarks_;               ///< of last_, in their order
    Beginning kept_;                ///< what the last two drawings had in common
    std::vector<Beginning> steps_;  ///< on the way there, for when they have less in common; the longest last
};

}  // namespace plumb::games
