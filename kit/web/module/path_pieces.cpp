// SPDX-License-Identifier: MIT
#include <web/module/path_pieces.h>

#include <stdexcept>

namespace plumb::web {

namespace {

struct Append {
    MotionPath& path;

    void operator()(const LineTo& line) const { path.lineTo(line.end); }
    void operator()(const ArcAround& arc) const { path.arcAround(arc.center, arc.angle); }
    void operator()(const CurveTo& curve) const { path.curveTo(curve.first, curve.second, curve.end); }
    void operator()(const CloseLine&) const { path.close(); }
    void operator()(const SplineThrough&) const {
        throw std::invalid_argument("MotionPath: splineThrough stands beside other pieces; it has to be the only one");
    }
};

}  // namespace

MotionPath pathOf(const PathPieces& pieces) {
    if (pieces.pieces.size() == 1) {
        if (const auto* spline = std::get_if<SplineThrough>(&pieces.pieces.front())) {
            std::vector<Vec2> points{pieces.start};
            points.insert(points.end(), spline->points.begin(), spline->points.end());
            return splineThrough(points, spline->closed);
        }
    }
    MotionPath path(pieces.start);
    for (const PathPiece& piece : pieces.pieces) std::visit(Append{path}, piece);
    return path;
}

}  // namespace plumb::web
