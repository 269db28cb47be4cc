// SPDX-License-Identifier: MIT
#include <plumb/shapes/chain.h>

#include <plumb/shapes/detail/counts.h>

namespace plumb {

std::vector<Shape> piecesOf(const Shape& shape) {
    const auto* chain = std::get_if<Chain>(&shape);
    if (chain == nullptr) return {shape};
    requireCount(*chain);
    const std::vector<Vec2>& points = chain->points;
    const std::size_t count = points.size();
    const std::size_t segments = chain->closed ? count : count - 1;
    std::vector<Shape> pieces;
    pieces.reserve(segments);
    for (std::size_t i = 0; i < segments; ++i) {
        Segment segment{points[i], points[(i + 1) % count]};
        if (chain->closed || i > 0) segment.before = points[(i + count - 1) % count];
        if (chain->closed || i + 1 < segments) segment.after = points[(i + 2) % count];
        pieces.emplace_back(segment);
    }
    return pieces;
}

}  // namespace plumb
