// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <plumb/collide/distance.h>
#include <plumb/collide/ray_cast.h>
#include <plumb/collide/shape_cast.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include <plumb/shapes/chain.h>

#include "cases.h"
#include "catch.h"

namespace plumb::test {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
/// What is nearer to a touch than this may be told of or not: roundings of places some rounds away [m].
constexpr double hair = 1e-9;

/// A piece of a shape where its body says that it is.
struct Piece {
    ShapeId id;
    Shape shape;
    Transform pose;
};

/// A world that wraps, after some steps, and all that it shows of itself.
class Scene {
public:
    explicit Scene(Random& random) : random_(random), wrap(anyWrap()), world({.gravity = {0, -5}, .wrap = wrap}) {
        for (int i = random.integer(2, 14); i > 0; --i) addBody();
        for (int i = random.integer(0, 4); i > 0; --i) world.step(1.0 / 60);
        for (const BodyId body : world.bodies()) {
            if (random.integer(0, 9) == 0) world.body(body).setPose(anywhere(), world.body(body).angle());
            for (const ShapeId id : world.body(body).shapes()) shapes.push_back(id);
        }
        for (const ShapeId id : shapes)
            for (const Shape& piece : piecesOf(world.shape(id).def().shape))
                pieces.push_back({id, piece, world.body(id.body).pose()});
    }

    Vec2 anywhere() { return {random_.uniform(-2.5, 2.5) * width(), random_.uniform(-2.5, 2.5) * height()}; }
    double width() const { return wrap.width.value_or(10); }
    double height() const { return wrap.height.value_or(10); }

    /// Calls visit(piece, pose) for all images of all pieces that can matter to a box.
    template <class Visit>
    void forEachImage(const Aabb& reach, Visit&& visit) const {
        for (const Piece& piece : pieces) {
            const Aabb box = aabbOf(piece.shape, piece.pose);
            const auto first = [](double still, double moving, const std::optional<double>& round) {
                return round ? static_cast<int>(std::floor((still - moving) / *round)) - 1 : 0;
            };
            const auto last = [](double still, double moving, const std::optional<double>& round) {
                return round ? static_cast<int>(std::ceil((still - moving) / *round)) + 1 : 0;
            };
            for (int x = first(reach.lower.x(), box.upper.x(), wrap.width);
                 x <= last(reach.upper.x(), box.lower.x(), wrap.width); ++x)
                for (int y = first(reach.lower.y(), box.upper.y(), wrap.height);
                     y <= last(reach.upper.y(), box.lower.y(), wrap.height); ++y) {
                    const Vec2 shift(x * wrap.width.value_or(0), y * wrap.height.value_or(0));
                    visit(piece, Transform{piece.pose.position + shift, piece.pose.rotation});
                }
        }
    }

    Shape anyShape() {
        const double size = random_.uniform(0.05, 0.12) * std::min(width(), height());
        switch (random_.integer(0, 4)) {
            case 0: return Capsule{{-size, 0}, {size, size}, 0.5 * size};
            case 1: return boxPolygon({size, 0.6 * size}, {0.5 * size, 0});
            case 2: return Segment{{-size, 0}, {2 * size, size}};
            case 3: return Polygon{{{-size, -size}, {size, -size}, {0, size}}, 0.2 * size};
            default: return Circle{size, {0, 0.5 * size}};
        }
    }

private:
    Wrap anyWrap() {
        const double w = random_.uniform(3, 20), h = w * random_.uniform(0.5, 2);
        switch (random_.integer(0, 2)) {
            case 0: return {.width = w};
            case 1: return {.height = h};
            default: return {.width = w, .height = h};
        }
    }
    void addBody() {
        BodyDef def{.type = random_.integer(0, 1) ? BodyType::Dynamic : BodyType::Static, .position = anywhere()};
        def.angle = random_.uniform(-3, 3);
        if (def.type == BodyType::Dynamic) {
            const double speed = random_.integer(0, 4) ? 3 : 400;
            def.velocity = {random_.uniform(-speed, speed), random_.uniform(-speed, speed)};
            def.shapes = {circle(0.03 * std::min(width(), height()))};
        }
        def.shapes.push_back({.shape = anyShape()});
        const double w = width(), h = height();
        const bool wide = def.type == BodyType::Static && random_.integer(0, 2) == 0;
        if (wide) def.angle = 0;
        if (wide) def.shapes.push_back({.shape = boxPolygon({0.5 * w, 0.02 * h})});
        if (wide) def.shapes.push_back({.shape = Chain{{{-0.4 * w, 0}, {0, 0.2 * h}, {0.4 * w, 0.1 * h}}}});
        world.add(def);
    }

    Random& random_;

public:
    Wrap wrap;
    World world;
    std::vector<ShapeId> shapes;
    std::vector<Piece> pieces;
};

using Name = std::pair<std::uint32_t, std::uint32_t>;
Name nameOf(const ShapeId& id) {
    return {id.body.index, id.number};
}

/// Of each shape that is met, the first fraction of the way.
template <class Meet>
std::map<Name, double> fractions(const Scene& scene, const Aabb& reach, Meet&& meet) {
    std::map<Name, double> first;
    scene.forEachImage(reach, [&](const Piece& piece, const Transform& pose) {
        const std::optional<CastPoint> met = meet(piece.shape, pose);
        if (!met) return;
        const auto [at, isNew] = first.try_emplace(nameOf(piece.id), met->fraction);
        if (!isNew) at->second = std::min(at->second, met->fraction);
    });
    return first;
}

double smallest(const std::map<Name, double>& fractions) {
    double least = 2;
    for (const auto& [name, fraction] : fractions) least = std::min(least, fraction);
    return least;
}

/// Shapes told of, and known of, and how far along the way; what is only grazed may be missing in one of the two.
bool agree(const std::vector<CastHit>& hits, const std::map<Name, double>& known, double length) {
    std::size_t same = 0;
    for (const CastHit& hit : hits) {
        const auto found = known.find(nameOf(hit.shape));
        if (found != known.end() && std::fabs(found->second - hit.fraction) * length < 1e-6) ++same;
    }
    return same == hits.size() && same == known.size();
}

bool isPlaced(const Scene& scene, const Vec2& point) {
    return scene.wrap.place(point) == point;
}

}  // namespace

TEST_CASE("20,000 rays and shapes cast around a world that wraps meet what they meet of its images",
          "[dynamics][wrap][tiles]") {
    Random random(40);
    int wrong = 0, met = 0, around = 0;
    for (int i = 0; i < cases(1000); ++i) {
        Scene scene(random);
        for (int k = 0; k < 20; ++k) {
            const Vec2 from = scene.anywhere(), to = random.integer(0, 9) ? scene.anywhere() : from;
            const Vec2 shift = to - from;
            const Shape shape = scene.anyShape();
            const Transform pose{from, Rot::fromAngle(random.uniform(-3, 3))};
            const bool isRay = k % 2 == 0;
            const Aabb start = isRay ? Aabb{from, from} : aabbOf(shape, pose);
            const Aabb reach = merge(start, {start.lower + shift, start.upper + shift});
            const auto known = fractions(scene, reach, [&](const Shape& other, const Transform& there) {
                return isRay ? castRay(from, to, other, there) : castShape(shape, pose, shift, other, there);
            });
            const auto hits = isRay ? scene.world.castRayAll(from, to) : scene.world.castShapeAll(shape, pose, shift);
            const auto first = isRay ? scene.world.castRay(from, to) : scene.world.castShape(shape, pose, shift);
            wrong += agree(hits, known, shift.norm()) ? 0 : 1;
            wrong += first.has_value() == !known.empty() ? 0 : 1;
            if (!first || known.empty()) continue;
            wrong += std::fabs(first->fraction - smallest(known)) * shift.norm() < 1e-6 ? 0 : 1;
            wrong += isPlaced(scene, first->point) ? 0 : 1;
            ++met;
            around += isPlaced(scene, from + first->fraction * shift) ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    CHECK(met > 5 * cases(1000));
    CHECK(around > met / 2);
}

TEST_CASE("20,000 boxes, shapes and points overlap in a world that wraps what they overlap of its images",
          "[dynamics][wrap][tiles]") {
    Random random(41);
    int wrong = 0, met = 0;
    for (int i = 0; i < cases(1000); ++i) {
        Scene scene(random);
        for (int k = 0; k < 20; ++k) {
            const Vec2 at = scene.anywhere();
            const Vec2 half(random.uniform(0, 0.7) * scene.width(), random.uniform(0.01, 0.3) * scene.height());
            const Transform pose{at, Rot::fromAngle(random.uniform(-3, 3))};
            const Shape shape = k % 3 == 0   ? Shape(boxPolygon(half, at))
                                : k % 3 == 1 ? scene.anyShape()
                                             : Shape(Circle{.radius = 0, .center = at});
            const Transform where = k % 3 == 1 ? pose : Transform{};
            std::set<Name> sure, maybe, told;
            scene.forEachImage(aabbOf(shape, where), [&](const Piece& piece, const Transform& there) {
                const double apart = distance(piece.shape, there, shape, where).separation;
                if (apart < -hair) sure.insert(nameOf(piece.id));
                if (apart < hair) maybe.insert(nameOf(piece.id));
            });
            const auto found = k % 3 == 0   ? scene.world.overlapBox({at - half, at + half})
                               : k % 3 == 1 ? scene.world.overlapShape(shape, pose)
                                            : scene.world.overlapPoint(at);
            for (const ShapeId& id : found) told.insert(nameOf(id));
            wrong += told.size() == found.size() ? 0 : 1;
            wrong += std::includes(told.begin(), told.end(), sure.begin(), sure.end()) ? 0 : 1;
            wrong += std::includes(maybe.begin(), maybe.end(), told.begin(), told.end()) ? 0 : 1;
            met += static_cast<int>(sure.size());
        }
    }
    CHECK(wrong == 0);
    CHECK(met > 5 * cases(1000));
}

TEST_CASE("nearest shapes of 10,000 points and distances of pairs go the short way round", "[dynamics][wrap][tiles]") {
    Random random(42);
    int wrong = 0, found = 0;
    for (int i = 0; i < cases(1000); ++i) {
        Scene scene(random);
        for (int k = 0; k < 10; ++k) {
            const Vec2 at = scene.anywhere();
            const double within = k % 3 == 0 ? endless : random.uniform(0, 0.5) * scene.width();
            const Vec2 round(2 * scene.width(), 2 * scene.height());
            double known = endless;
            scene.forEachImage({at - 5 * round, at + 5 * round}, [&](const Piece& piece, const Transform& pose) {
                known = std::min(known, distance(piece.shape, pose, Circle{.radius = 0}, {at, {}}).separation);
            });
            const auto nearest = scene.world.nearest(at, within);
            if (std::fabs(known - within) > hair) wrong += nearest.has_value() == (known <= within) ? 0 : 1;
            if (!nearest) continue;
            ++found;
            wrong += std::fabs(nearest->separation - known) < hair && isPlaced(scene, nearest->point) ? 0 : 1;

            const auto any = [&] {
                return scene
                    .shapes[static_cast<std::size_t>(random.integer(0, static_cast<int>(scene.shapes.size()) - 1))];
            };
            const ShapeId a = any(), b = any();
            if (a == b) continue;
            double least = endless;
            for (const Piece& own : scene.pieces) {
                if (own.id != a) continue;
                const Aabb box = aabbOf(own.shape, own.pose);
                scene.forEachImage(
                    {box.lower - round, box.upper + round}, [&](const Piece& other, const Transform& pose) {
                        if (other.id != b) return;
                        least = std::min(least, distance(own.shape, own.pose, other.shape, pose).separation);
                    });
            }
            const Distance told = scene.world.distance(a, b);
            wrong += std::fabs(told.separation - least) < hair ? 0 : 1;
            wrong += isPlaced(scene, told.pointA) && isPlaced(scene, told.pointB) ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    CHECK(found > 2 * cases(1000));
}

}  // namespace plumb::test
