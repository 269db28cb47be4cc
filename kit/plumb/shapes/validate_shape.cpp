// SPDX-License-Identifier: MIT
// Which shapes, masses and tile maps are refused? And the polygon of a box, which refuses its sizes.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <plumb/math/check.h>
#include <plumb/math/require_members.h>
#include <plumb/shapes/describe_shape.h>
#include <plumb/shapes/detail/checks.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {
namespace {

// The smallest edge, relative to the polygon's size, and the smallest sine of the turn at a corner. The hot loops store
// corners as floats: anything smaller is less than ten of their last places.
constexpr double polygonTolerance = 1e-6;

std::string cornerName(const std::string& field, std::size_t index) {
    return field + ".vertices[" + std::to_string(index) + "]";
}

[[noreturn]] void refuseCorner(const Polygon& polygon, std::size_t index, const std::string& field,
                               const std::string& complaint) {
    refuse(cornerName(field, index), toText(polygon.vertices[index]) + " " + complaint);
}

// The edges, times a power of two, so that products of huge or tiny lengths neither overflow nor underflow. Without
// heap memory, because overlap() validates its shapes on each call.
struct Edges {
    std::array<Vec2, maxPolygonVertices> room;
    std::size_t count = 0;

    std::size_t size() const { return count; }
    const Vec2& operator[](std::size_t i) const { return room[i]; }
    std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : count - 1; }
    std::size_t after(std::size_t i) const { return i + 1 < count ? i + 1 : 0; }
    const Vec2* begin() const { return room.data(); }
    const Vec2* end() const { return room.data() + count; }
};

Edges scaledEdges(const Polygon& polygon) {
    double largest = 0;
    for (const Vec2& v : polygon.vertices) largest = std::max({largest, std::fabs(v.x()), std::fabs(v.y())});
    int exponent = 0;
    std::frexp(largest, &exponent);
    // In two factors: the whole power is not representable where the largest number is denormal.
    const double some = std::ldexp(1, -exponent / 2), rest = std::ldexp(1, -exponent - -exponent / 2);
    const auto scaled = [&](const Vec2& v) { return Vec2(v * some * rest); };
    Edges edges;
    edges.count = polygon.vertices.size();
    for (std::size_t i = 0; i < edges.count; ++i)
        edges.room[i] = scaled(polygon.vertices[edges.after(i)]) - scaled(polygon.vertices[i]);
    return edges;
}

void requireDistinctCorners(const Polygon& polygon, const Edges& edges, const std::string& field) {
    // The largest distance of a corner from the first.
    double extent = 0;
    Vec2 fromFirst{0, 0};
    for (const Vec2& edge : edges) {
        fromFirst += edge;
        extent = std::max(extent, fromFirst.norm());
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!(edges[i].norm() > polygonTolerance * extent))
            refuseCorner(polygon, edges.after(i), field, "repeats the corner before it");
}

// Twice the signed area.
double doubleSignedArea(const Edges& edges) {
    double area = 0;
    Vec2 fromFirst{0, 0};
    for (const Vec2& edge : edges) {
        area += cross(fromFirst, edge);
        fromFirst += edge;
    }
    return area;
}

void requireLeftTurns(const Polygon& polygon, const Edges& edges, const std::string& field) {
    std::array<double, maxPolygonVertices> room;
    const std::span<double> sines(room.data(), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Vec2& before = edges[edges.before(i)];
        sines[i] = cross(before, edges[i]) / (before.norm() * edges[i].norm());
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!(std::fabs(sines[i]) > polygonTolerance))
            refuseCorner(polygon, i, field, "lies in line with the corners beside it");
    const bool allRight = std::all_of(sines.begin(), sines.end(), [](double sine) { return sine < 0; });
    if (allRight && doubleSignedArea(edges) < 0)
        refuse(field + ".vertices", "the corners run clockwise, not counter-clockwise");
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (sines[i] < 0) refuseCorner(polygon, i, field, "makes the polygon not convex");
}

// Where every turn is to the left, the edges start to point upwards once per revolution. A pentagram has two.
void requireOneWinding(const Edges& edges, const std::string& field) {
    const auto up = [](const Vec2& edge) { return edge.y() > 0 || (edge.y() == 0 && edge.x() > 0); };
    int windings = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!up(edges[i]) && up(edges[edges.after(i)])) ++windings;
    if (windings != 1)
        refuse(field + ".vertices", "the corners wind around " + std::to_string(windings) + " times, not once");
}

// What the description of each shape cannot say: what holds between its members, and between its corners.

void validateTogether(const Circle&, const std::string&) {}
void validateTogether(const TileMap&, const std::string&) {}

void validateTogether(const Polygon& polygon, const std::string& field) {
    requireCount(polygon, field);
    const Edges edges = scaledEdges(polygon);
    requireDistinctCorners(polygon, edges, field);
    requireLeftTurns(polygon, edges, field);
    requireOneWinding(edges, field);
}

bool same(const Vec2& a, const Vec2& b) {
    return a.x() == b.x() && a.y() == b.y();
}

/// Does a line from a to b reverse straight back to c?
bool foldsBack(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 in = (b - a).stableNormalized();
    const Vec2 out = (c - b).stableNormalized();
    return in.dot(out) < 0 && std::fabs(cross(in, out)) < polygonTolerance;
}

void validateTogether(const Capsule& capsule, const std::string& field) {
    if (same(capsule.start, capsule.end))
        refuse(field + ".end", toText(capsule.end) + " is the same point as start: that is a circle");
}

void validateNeighbour(const Vec2& beyond, const Vec2& joint, const Vec2& other, const std::string& field) {
    if (same(beyond, joint)) refuse(field, toText(beyond) + " is the end of the segment, not a point beyond");
    if (foldsBack(other, joint, beyond)) refuse(field, toText(beyond) + " folds the line straight back on itself");
}

void validateTogether(const Segment& segment, const std::string& field) {
    if (same(segment.start, segment.end)) refuse(field + ".end", toText(segment.end) + " is the same point as start");
    if (segment.before) validateNeighbour(*segment.before, segment.start, segment.end, field + ".before");
    if (segment.after) validateNeighbour(*segment.after, segment.end, segment.start, field + ".after");
}

void validateTogether(const Chain& chain, const std::string& field) {
    requireCount(chain, field);
    const std::size_t count = chain.points.size();
    const auto name = [&](std::size_t i) { return field + ".points[" + std::to_string(i) + "]"; };
    const auto point = [&](std::size_t i) -> const Vec2& { return chain.points[i % count]; };
    const std::size_t segments = chain.closed ? count : count - 1;
    for (std::size_t i = 0; i < segments; ++i)
        if (same(point(i), point(i + 1)))
            refuse(name((i + 1) % count), toText(point(i + 1)) + " repeats the point before it");
    const std::size_t joints = chain.closed ? count : count - 2;
    for (std::size_t i = 0; i < joints; ++i)
        if (foldsBack(point(i), point(i + 1), point(i + 2)))
            refuse(name((i + 1) % count), toText(point(i + 1)) + " folds the line straight back on itself");
}

}  // namespace

Polygon boxPolygon(const Vec2& halfSize, const Vec2& center) {
    requirePositive(halfSize, "box.halfSize");
    requireFinite(center, "box.center");
    const double w = halfSize.x();
    const double h = halfSize.y();
    return {{center + Vec2(-w, -h), center + Vec2(w, -h), center + Vec2(w, h), center + Vec2(-w, h)}};
}

void refuseCount(const Polygon& polygon, std::string_view field) {
    const std::size_t count = polygon.vertices.size();
    refuse(std::string(field) + ".vertices",
           std::to_string(count) + " corners are " +
               (count < 3 ? "fewer than 3" : "more than " + std::to_string(maxPolygonVertices)));
}

void refuseCount(const Chain& chain, std::string_view field) {
    refuse(std::string(field) + ".points", std::to_string(chain.points.size()) + " points are fewer than " +
                                               (chain.closed ? "3 of a closed chain" : "2"));
}

void validate(const Shape& shape, const std::string& field) {
    std::visit(
        [&field]<class Kind>(const Kind& kind) {
            if constexpr (!std::is_same_v<Kind, TileMap>) requireMembers(kind, {field});
            validateTogether(kind, field);
        },
        shape);
}

void requireMass(const Mass& mass, const char* field, std::size_t index) {
    requireMembers(mass, {.name = field, .index = static_cast<std::ptrdiff_t>(index)});
}

void requireNumbers(const TileMapDef& def) {
    requireMembers(def, {"TileMapDef"});
}

}  // namespace plumb
