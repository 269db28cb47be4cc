// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/obstacles.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <compare/scene/joint_geometry.h>
#include <compare/scene/state.h>

namespace plumb::compare {
namespace {

constexpr double nearEnough = 1e-9;   // up to this distance from a line, a point is on it [m]
constexpr double oneWaySpread = 0.5;  // cosine of 60 degrees: solid are faces this near to the one-way direction [-]

/// The faces and corners of one shape.
class ShapeObstacles {
public:
    ShapeObstacles(const Scene& scene, const Surface& surface, Obstacles& found)
        : body_(scene.bodies[surface.body]), surface_(surface), pose_(startPose(body_.def)), found_(found) {
        const auto moves = [&](const SceneMover& mover) { return mover.body == body_.name; };
        turns_ = body_.def.angularVelocity != 0 || std::ranges::any_of(scene.movers, moves);
        velocity_ = body_.def.type == BodyType::Kinematic ? body_.def.velocity : Vec2(0, 0);
    }

    void operator()(const Circle& circle) { addCorner(circle.center, circle.radius); }
    void operator()(const Capsule& capsule) { addRing({capsule.start, capsule.end}, capsule.radius); }
    void operator()(const Polygon& polygon) { addRing(polygon.vertices, polygon.radius); }
    void operator()(const Segment& segment) { addRing({segment.start, segment.end}, 0); }
    void operator()(const Chain& chain) {
        for (std::size_t i = 1; i < chain.points.size(); ++i) addRing({chain.points[i - 1], chain.points[i]}, 0);
        if (chain.closed) addRing({chain.points.back(), chain.points.front()}, 0);
    }
    void operator()(const TileMap& map) {
        for (int row = 0; row < map.rows(); ++row)
            for (int column = 0; column < map.columns(); ++column) addTile(map, {column, row});
    }

private:
    static bool isFull(const TileMap& map, Cell cell) { return map.contains(cell) && !isEmpty(map.at(cell)); }

    void addTile(const TileMap& map, Cell cell) {
        const Tile tile = map.at(cell);
        if (isEmpty(tile)) return;
        if (tile.form != TileForm::Full || !isSolid(tile))
            throw Unsupported("closedForm.bodies: " + body_.name +
                              " has tiles that do not fill their cells, and no formula is known here");
        const std::vector<Vec2> corners = map.cornersOf(cell);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2& from = corners[i];
            const Vec2& to = corners[(i + 1) % corners.size()];
            const Vec2 out = -perp(Vec2(to - from)) / map.size();
            const Cell beside{cell.column + static_cast<int>(std::lround(out.x())),
                              cell.row + static_cast<int>(std::lround(out.y()))};
            if (!isFull(map, beside)) addFace(from, to, 0);
        }
        for (const Vec2& corner : corners) addCorner(corner, 0);
    }

    /// Counter-clockwise; two points give both sides of a line.
    void addRing(const std::vector<Vec2>& points, double radius) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            addFace(points[i], points[(i + 1) % points.size()], radius);
            addCorner(points[i], radius);
        }
    }

    void addFace(const Vec2& from, const Vec2& to, double radius) {
        const Vec2 a = pose_ * from, b = pose_ * to;
        const Vec2 normal = -perp(Vec2(b - a)).normalized(), along = tangentOf(normal);
        if (surface_.def->oneWay) {
            const Vec2 way = pose_.rotation * Vec2(surface_.def->oneWay->normalized());
            if (way.dot(normal) < oneWaySpread) return;
        }
        found_.faces.push_back({surface_, normal, normal.dot(a) + radius, std::min(along.dot(a), along.dot(b)),
                                std::max(along.dot(a), along.dot(b)), velocity_, turns_});
    }
    void addCorner(const Vec2& local, double radius) {
        if (!surface_.def->oneWay) found_.corners.push_back({surface_, pose_ * local, radius, velocity_, turns_});
    }

    const SceneBody& body_;
    Surface surface_;
    Transform pose_;
    Obstacles& found_;
    Vec2 velocity_{0, 0};
    bool turns_ = false;
};

bool continues(const Face& face, const Face& next) {
    return face.surface.def == next.surface.def && (face.normal - next.normal).norm() < nearEnough &&
           std::abs(face.offset - next.offset) < nearEnough && next.low <= face.high + nearEnough;
}

void joinFaces(std::vector<Face>& faces) {
    const auto key = [](const Face& f) {
        return std::tuple(f.surface.body, f.surface.shape, f.normal.x(), f.normal.y(), f.offset, f.low);
    };
    std::ranges::sort(faces, {}, key);
    std::vector<Face> joined;
    for (const Face& face : faces) {
        if (!joined.empty() && continues(joined.back(), face))
            joined.back().high = std::max(joined.back().high, face.high);
        else
            joined.push_back(face);
    }
    faces = std::move(joined);
}

/// Nothing can hit a corner in the middle of a face.
bool isInside(const Corner& corner, const Face& face) {
    const double along = tangentOf(face.normal).dot(corner.position);
    return face.surface.body == corner.surface.body &&
           std::abs(face.normal.dot(corner.position) + corner.radius - face.offset) < nearEnough &&
           along > face.low + nearEnough && along < face.high - nearEnough;
}

}  // namespace

Vec2 tangentOf(const Vec2& normal) {
    return -perp(normal);
}

bool mayTouch(const ShapeDef& a, const ShapeDef& b) {
    if (a.sensor || b.sensor) return false;
    if (a.filter.group != 0 && a.filter.group == b.filter.group) return a.filter.group > 0;
    return (a.filter.category & b.filter.mask) != 0 && (b.filter.category & a.filter.mask) != 0;
}

bool mayTouch(const BodyDef& a, const BodyDef& b) {
    if (!a.enabled || !b.enabled) return false;
    return std::ranges::any_of(a.shapes, [&](const ShapeDef& mine) {
        return std::ranges::any_of(b.shapes, [&](const ShapeDef& other) { return mayTouch(mine, other); });
    });
}

Obstacles obstaclesOf(const Scene& scene, const BodyDef& body) {
    Obstacles found;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        if (&def == &body || def.type == BodyType::Dynamic || !def.enabled) continue;
        for (std::size_t k = 0; k < def.shapes.size(); ++k) {
            const ShapeDef& shape = def.shapes[k];
            if (std::ranges::none_of(body.shapes, [&](const ShapeDef& own) { return mayTouch(own, shape); })) continue;
            std::visit(ShapeObstacles(scene, {i, k, &shape}, found), shape.shape);
        }
    }
    joinFaces(found.faces);
    std::erase_if(found.corners, [&](const Corner& corner) {
        return std::ranges::any_of(found.faces, [&](const Face& face) { return isInside(corner, face); });
    });
    return found;
}

}  // namespace plumb::compare
