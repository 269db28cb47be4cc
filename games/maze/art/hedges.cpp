// SPDX-License-Identifier: MIT
#include <games/maze/art/hedges.h>

#include <cmath>
#include <numbers>
#include <utility>

#include <games/maze/layout.h>
#include <plumb/math/random.h>

namespace plumb::games::maze {
namespace {

constexpr int beyond = 2;  ///< the tunnel is drawn this far beyond the map [tiles]
constexpr int arcSteps = 6;

/// The house counts as hedge here: drawHouse draws over it.
bool isHedge(int column, int row) {
    if (column < -beyond || column >= columns + beyond || row < 0 || row >= rows) return true;
    return isSolid(mazeMap().at(mazeMap().wrapped({column, row})));
}

/// An edge between a wall and a lane, from one cell corner to the next. The wall is on its left.
struct Edge {
    Vec2 from, along;
};

std::vector<Edge> edgesOfHedges() {
    std::vector<Edge> edges;
    const auto add = [&](double x, double y, double dx, double dy) { edges.push_back({{x, y}, {dx, dy}}); };
    for (int row = 0; row < rows; ++row)
        for (int column = -beyond; column < columns + beyond; ++column) {
            if (!isHedge(column, row)) continue;
            if (!isHedge(column, row - 1)) add(column, row, 1, 0);
            if (!isHedge(column + 1, row)) add(column + 1, row, 0, 1);
            if (!isHedge(column, row + 1)) add(column + 1, row + 1, -1, 0);
            if (!isHedge(column - 1, row)) add(column, row + 1, 0, -1);
        }
    // The tunnel's ends have no wall, so they need edges of their own.
    for (int row = 0; row < rows; ++row) {
        if (isHedge(-beyond, row)) continue;
        add(-beyond, row, 0, 1);
        add(columns + beyond, row + 1, 0, -1);
    }
    return edges;
}

/// Takes connected edges out of the list, until none follows the last.
std::vector<Edge> takeLoop(std::vector<Edge>& edges) {
    std::vector<Edge> loop{edges.back()};
    edges.pop_back();
    for (bool found = true; found;) {
        found = false;
        const Vec2 end = loop.back().from + loop.back().along;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (edges[i].from != end) continue;
            loop.push_back(edges[i]);
            edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
            found = true;
            break;
        }
    }
    return loop;
}

Vec2 leftOf(const Vec2& v) {
    return {-v.y(), v.x()};
}

/// A quarter of a circle from one edge to the next.
void addCorner(Outline& outline, const Vec2& corner, const Vec2& in, const Vec2& out, double radius) {
    const Vec2 center = corner - radius * in + radius * out;
    for (int step = 0; step <= arcSteps; ++step) {
        const double angle = std::numbers::pi / 2 * step / arcSteps;
        outline.push_back(center + radius * (std::sin(angle) * in - std::cos(angle) * out));
    }
}

Outline smooth(const std::vector<Edge>& loop, double inset, double radius) {
    Outline outline;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 in = loop[(i + loop.size() - 1) % loop.size()].along, out = loop[i].along;
        if (in == out) continue;
        addCorner(outline, loop[i].from + inset * (leftOf(in) + leftOf(out)), in, out, radius);
    }
    return outline;
}

double areaOf(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

/// Small flowers at random places, the same in every game.
std::vector<std::pair<Vec2, Color>> flowers() {
    std::vector<std::pair<Vec2, Color>> found;
    Random random(11);
    const std::array<Color, 3> colors{Color::hex(0x8fd6b4), Color::hex(0xd8c6ff), Color::hex(0xffd9a0)};
    for (int row = 3; row < rows - 4; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const bool inside = isHedge(column, row) && isHedge(column + 1, row) && isHedge(column, row + 1) &&
                                isHedge(column + 1, row + 1);
            const bool house = row >= 16 && row <= 20 && column >= 9 && column <= 17;
            if (!inside || house || random.integer(0, 3) != 0) continue;
            const Vec2 at(column + 1 + random.uniform(-0.3, 0.3), row + 1 + random.uniform(-0.3, 0.3));
            found.emplace_back(at, colors[static_cast<std::size_t>(random.integer(0, 2))]);
        }
    return found;
}

void drawHouse(Canvas& canvas, const Color& rim) {
    const Vec2 center(14, rows - 17.5);
    canvas.box(center, {3.72, 2.22}, darker(wood, 0.45), 0.5);
    canvas.box(center, {3.72, 2.22}, stroke(mix(wood, rim, 0.15), 0.16), 0.5);
    canvas.box(center, {3.2, 1.7}, Color::hex(0x2a1a2e), 0.35);
    for (int i = 0; i < 3; ++i)  // cushions
        canvas.ellipse(center + Vec2(2.0 * (i - 1), -1.05), {0.95, 0.42}, Color::hex(0x6d3a5c));
    const Vec2 door = center + Vec2(0, 1.96);
    canvas.rect(door - Vec2(1, 0.3), {2, 0.6}, Color::hex(0x2a1a2e));
    canvas.rect(door - Vec2(1, 0.1), {2, 0.2}, wood, 0.1);
}

}  // namespace

Hedges hedgesOf(double inset, double radius) {
    Hedges hedges;
    for (std::vector<Edge> edges = edgesOfHedges(); !edges.empty();) {
        const Outline outline = smooth(takeLoop(edges), inset, radius);
        (areaOf(outline) > 0 ? hedges.islands : hedges.lawns).push_back(outline);
    }
    return hedges;
}

void drawGarden(Canvas& canvas, const GardenLook& look, double flash) {
    static const Hedges outer = hedgesOf(0.28, 0.42), inner = hedgesOf(0.58, 0.3);
    static const auto specks = flowers();
    const Color rim = mix(look.rim, hedgeFlash, flash);
    const Color leaf = mix(lighter(look.hedge, 0.07), look.rim, 0.35 * flash);
    canvas.box({14, 17.5}, {14.3, 15.8}, look.hedge, 0.9);
    canvas.box({14, 17.5}, {14.3, 15.8}, stroke(rim.faded(0.55), 0.12), 0.9);
    const Canvas::Scope scope = canvas.clip(gardenCorner, gardenSize);
    canvas.box({14, 17.5}, {13.94, 15.44}, leaf, 0.6);
    for (const Outline& outline : inner.lawns) canvas.polygon(outline, look.hedge);
    for (const Outline& outline : outer.lawns) {
        canvas.polygon(outline, look.lawn);
        canvas.polygon(outline, stroke(rim, 0.15));
    }
    for (const Outline& outline : outer.islands) {
        canvas.polygon(outline, look.hedge);
        canvas.polygon(outline, stroke(rim, 0.15));
    }
    for (const Outline& outline : inner.islands) canvas.polygon(outline, leaf);
    for (const auto& [at, color] : specks) canvas.circle(at, 0.09, color.faded(0.55));
    drawHouse(canvas, rim);
}

}  // namespace plumb::games::maze
