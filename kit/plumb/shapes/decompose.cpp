// SPDX-License-Identifier: MIT
#include <plumb/shapes/decompose.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/detail/sorting.h>
#include <plumb/math/random.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {
namespace {

using Indices = std::vector<std::size_t>;
using Side = std::pair<std::size_t, std::size_t>;

std::string nameOf(std::size_t index) {
    return "convexPieces.outline[" + std::to_string(index) + "]";
}

/// An outline in progress: its points as given, and scaled to numbers near 1.
struct Outline {
    std::span<const Vec2> points;
    std::vector<Vec2> scaled;

    [[noreturn]] void refuseAt(std::size_t index, const std::string& complaint) const {
        refuse(nameOf(index), toText(points[index]) + " " + complaint);
    }
    double sine(std::size_t before, std::size_t at, std::size_t after) const {
        const Vec2 in = scaled[at] - scaled[before], out = scaled[after] - scaled[at];
        return cross(in, out) / (in.norm() * out.norm());
    }
    bool foldsBack(std::size_t before, std::size_t at, std::size_t after) const {
        return (scaled[at] - scaled[before]).dot(scaled[after] - scaled[at]) < 0;
    }
};

/// One pass along the outline that removes points which repeat the one before or hardly make a turn.
Indices withoutFlats(const Outline& outline, const Indices& corners, double shortest) {
    Indices kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t at = corners[i], before = kept.empty() ? corners.back() : kept.back();
        const std::size_t after = i + 1 < corners.size() ? corners[i + 1] : kept.empty() ? before : kept.front();
        if (!((outline.scaled[at] - outline.scaled[before]).norm() > shortest)) continue;
        // If the next point repeats this one, the next one is left out instead.
        const bool repeated = !((outline.scaled[after] - outline.scaled[at]).norm() > shortest);
        if (!repeated && std::fabs(outline.sine(before, at, after)) <= cornerTolerance) {
            if (outline.foldsBack(before, at, after)) outline.refuseAt(at, "folds the outline straight back on itself");
            continue;
        }
        kept.push_back(at);
    }
    return kept;
}

double doubleSignedArea(const Outline& outline, const Indices& corners) {
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += cross(outline.scaled[corners[i]], outline.scaled[corners[i + 1 < corners.size() ? i + 1 : 0]]);
    return area;
}

/// On which side of the line from a to b is c? 0 if it is on the line.
int sideOf(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double turn = cross(Vec2(b - a), Vec2(c - a));
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

bool boxHolds(const Vec2& a, const Vec2& b, const Vec2& p) {
    return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&  //
           std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const int abc = sideOf(a, b, c), abd = sideOf(a, b, d), cda = sideOf(c, d, a), cdb = sideOf(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && boxHolds(a, b, c)) || (abd == 0 && boxHolds(a, b, d)) ||  //
           (cda == 0 && boxHolds(c, d, a)) || (cdb == 0 && boxHolds(c, d, b));
}

/// Neighbouring edges do not intersect again: edges that fold back have been refused before.
void requireSimple(const Outline& outline, const Indices& corners) {
    const std::size_t count = corners.size();
    const auto at = [&](std::size_t i) -> const Vec2& { return outline.scaled[corners[i % count]]; };
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            if (i == 0 && j + 1 == count) continue;
            if (!meet(at(i), at(i + 1), at(j), at(j + 1))) continue;
            outline.refuseAt(corners[i], "begins an edge that meets the one from " + nameOf(corners[j]) + " " +
                                             toText(outline.points[corners[j]]) +
                                             ": an outline may neither cross nor touch itself");
        }
    }
}

Indices cornersOf(const Outline& outline) {
    Indices corners(outline.points.size());
    std::iota(corners.begin(), corners.end(), std::size_t{0});
    const double shortest = cornerTolerance * (corners.empty() ? 0 : diagonalOf(outline.scaled));
    for (std::size_t before = corners.size() + 1; corners.size() < before;) {
        before = corners.size();
        corners = withoutFlats(outline, corners, shortest);
    }
    if (corners.size() < 3)
        refuse("convexPieces.outline", std::to_string(corners.size()) + " corners, made of " +
                                           std::to_string(outline.points.size()) + " points, are fewer than 3");
    requireSimple(outline, corners);
    if (doubleSignedArea(outline, corners) < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

/// Convex pieces that are merged across diagonals.
class PieceMerger {
public:
    PieceMerger(const Outline& outline, std::vector<Indices> pieces) : outline_(outline), pieces_(std::move(pieces)) {
        for (std::size_t i = 0; i < pieces_.size(); ++i) addSides(i);
    }

    /// Removes each diagonal where that is possible: first those of pieces too thin to be valid, then all in this
    /// order.
    std::vector<Indices> run(const std::vector<Side>& order) && {
        for (const Side& side : order)
            if (!isConvex(pieceOf(side)) || !isConvex(pieceOf(opposite(side)))) merge(side);
        for (const Side& side : order) merge(side);
        std::vector<Indices> merged;
        for (const Indices& piece : pieces_)
            if (!piece.empty()) merged.push_back(withoutLines(piece));
        return merged;
    }

    /// Each once, the longest first.
    std::vector<Side> diagonals() const {
        std::vector<std::pair<double, Side>> found;
        for (const auto& [side, piece] : owner_)
            if (side.first < side.second && owner_.contains(opposite(side)))
                found.push_back({-(outline_.scaled[side.first] - outline_.scaled[side.second]).norm(), side});
        sortBy(found, std::identity{});
        std::vector<Side> sides;
        for (const auto& [length, side] : found) sides.push_back(side);
        return sides;
    }

private:
    void addSides(std::size_t i) {
        const Indices& piece = pieces_[i];
        for (std::size_t k = 0; k < piece.size(); ++k) owner_[{piece[k], piece[(k + 1) % piece.size()]}] = i;
    }

    /// A point is so near to the line between its neighbours that only rounding moved it off that line.
    bool isOnLine(std::size_t before, std::size_t at, std::size_t after) const {
        const Vec2 in = outline_.scaled[at] - outline_.scaled[before],
                   out = outline_.scaled[after] - outline_.scaled[at];
        return std::fabs(cross(in, out)) <= 1e-14 * (in + out).norm() && in.dot(out) > 0;
    }
    Indices withoutLines(const Indices& piece) const {
        Indices kept;
        const std::size_t count = piece.size();
        for (std::size_t k = 0; k < count; ++k)
            if (!isOnLine(piece[(k + count - 1) % count], piece[k], piece[(k + 1) % count])) kept.push_back(piece[k]);
        return kept;
    }
    bool isConvex(const Indices& piece) const {
        const Indices corners = withoutLines(piece);
        const std::size_t count = corners.size();
        if (count < 3 || count > static_cast<std::size_t>(maxPolygonVertices)) return false;
        for (std::size_t k = 0; k < count; ++k)
            if (!(outline_.sine(corners[k], corners[(k + 1) % count], corners[(k + 2) % count]) > cornerTolerance))
                return false;
        return true;
    }

    static Side opposite(const Side& side) { return {side.second, side.first}; }
    const Indices& pieceOf(const Side& side) const { return pieces_[owner_.at(side)]; }

    void merge(const Side& side) {
        const std::size_t kept = owner_.at(side), gone = owner_.at(opposite(side));
        if (kept == gone) return;  // merged before
        // One piece from the diagonal's end around to its start, then the other piece back.
        const auto open = [](Indices piece, std::size_t first) {
            std::rotate(piece.begin(), std::find(piece.begin(), piece.end(), first), piece.end());
            return piece;
        };
        Indices all = open(pieces_[kept], side.second);
        const Indices rest = open(pieces_[gone], side.first);
        all.insert(all.end(), rest.begin() + 1, rest.end() - 1);
        if (!isConvex(all)) return;
        pieces_[kept] = std::move(all);
        pieces_[gone].clear();
        addSides(kept);
        owner_[side] = owner_[opposite(side)] = kept;
    }

    const Outline& outline_;
    std::vector<Indices> pieces_;
    std::map<Side, std::size_t> owner_;
};

/// Which diagonals remain depends on the order of removal: the best of several orders is taken. The orders are the same
/// for the same outline.
std::vector<Indices> merged(const Outline& outline, const std::vector<Indices>& triangles) {
    constexpr std::size_t work = 512;  // triangles, all tries together
    const PieceMerger unmerged(outline, triangles);
    std::vector<Side> order = unmerged.diagonals();
    std::vector<Indices> best = PieceMerger(unmerged).run(order);
    Random random(1);
    for (std::size_t tries = work / (triangles.size() + 16); tries > 0 && best.size() > 2; --tries) {
        for (std::size_t i = order.size() - 1; i > 0; --i)
            std::swap(order[i], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
        std::vector<Indices> pieces = PieceMerger(unmerged).run(order);
        if (pieces.size() < best.size()) best = std::move(pieces);
    }
    return best;
}

Polygon polygonOf(const Outline& outline, const Indices& corners) {
    Polygon polygon;
    for (const std::size_t corner : corners) polygon.vertices.push_back(outline.points[corner]);
    try {
        validate(polygon, "piece");
    } catch (const std::invalid_argument& fault) {
        outline.refuseAt(
            corners.empty() ? 0 : corners.front(),
            std::string("is of a part of the outline that is too thin for a polygon (") + fault.what() + ")");
    }
    return polygon;
}

}  // namespace

std::vector<Polygon> convexPieces(std::span<const Vec2> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) requireFinite(points[i], nameOf(i));
    if (points.empty()) refuse("convexPieces.outline", "0 points are fewer than 3");
    // Twice, because the first point may be far from the body's origin.
    const Outline outline{points, scaledPoints(scaledPoints(points))};
    const Indices corners = cornersOf(outline);
    std::vector<Vec2> positions;
    for (const std::size_t corner : corners) positions.push_back(outline.scaled[corner]);
    std::vector<Indices> triangles;
    for (const Triangle& t : triangulate(positions)) triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    std::vector<Polygon> pieces;
    for (const Indices& piece : merged(outline, triangles)) pieces.push_back(polygonOf(outline, piece));
    return pieces;
}

}  // namespace plumb
