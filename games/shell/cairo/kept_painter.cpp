// SPDX-License-Identifier: MIT
#include <games/shell/cairo/kept_painter.h>

#include <algorithm>
#include <cstring>

namespace plumb::games {
namespace {

constexpr std::size_t mostSteps = 6;    ///< each holds a picture in memory
constexpr std::size_t leastAStep = 16;  ///< [marks]

const Clip* clipOf(const Drawing& drawing, const Mark& mark) {
    return mark.clip < 0 ? nullptr : &drawing.clips[static_cast<std::size_t>(mark.clip)];
}

bool isSame(const Drawing& a, const Mark& inA, const Drawing& b, const Mark& inB) {
    const Clip *clipA = clipOf(a, inA), *clipB = clipOf(b, inB);
    const bool sameClip = clipA == nullptr || clipB == nullptr ? clipA == clipB : *clipA == *clipB;
    return sameClip && inA == inB;
}

void copy(Picture& from, const PixelView& to) {
    const PixelView view = from.view();
    for (int row = 0; row < to.size.height; ++row)
        std::memcpy(reinterpret_cast<char*>(to.pixels) + row * to.stride,
                    reinterpret_cast<const char*>(view.pixels) + row * view.stride,
                    static_cast<std::size_t>(view.stride));
}

}  // namespace

void KeptPainter::paint(const Drawing& drawing, const PixelView& to) {
    if (!(drawing.size == last_.size)) lastMarks_.clear();
    Drawing now = drawing;
    const Marks marks = now.inOrder();
    std::size_t same = 0;
    while (same < std::min(marks.size(), lastMarks_.size()) && isSame(now, *marks[same], last_, *lastMarks_[same]))
        ++same;
    keep(marks, now, same);
    if (same > 0) copy(kept_.picture, to);
    painter_.paint(now, std::span(marks).subspan(same), to);
    last_ = std::move(now);
    lastMarks_ = marks;  // the pointers stay valid: a move keeps the elements in place
}

/// Makes kept_ the picture of the marks that the last two drawings have in common, from the longest step in both.
void KeptPainter::keep(const Marks& marks, const Drawing& drawing, std::size_t same) {
    while (!steps_.empty() && steps_.back().marks > same) steps_.pop_back();
    if (same < kept_.marks || same == 0) kept_ = steps_.empty() ? Beginning{Picture(drawing.size), 0} : steps_.back();
    for (const std::size_t step : {same / 2, same * 3 / 4, same * 7 / 8})
        if (step >= kept_.marks + leastAStep && steps_.size() < mostSteps) {
            extend(marks, drawing, step);
            steps_.push_back(kept_);
        }
    extend(marks, drawing, same);
}

void KeptPainter::extend(const Marks& marks, const Drawing& drawing, std::size_t to) {
    if (to <= kept_.marks) return;
    painter_.paint(drawing, std::span(marks).subspan(kept_.marks, to - kept_.marks), kept_.picture.view());
    kept_.marks = to;
}

}  // namespace plumb::games
