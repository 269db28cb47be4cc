// SPDX-License-Identifier: MIT
// Structures of many joints: trusses, bridges, wheels, cloths, nets, chain mail and soft bodies.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <plumb/dynamics/joints/lanes/island_layout.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "kit/usual_world.h"

namespace plumb::test {

enum class LinkKind : std::uint8_t { Hinge, Rod, Rope, Weld };

/// Bodies that touch nothing, and joints between them, in a world of their own.
class Structure {
public:
    World world;
    std::string name;
    double link;  ///< the distance of neighbours' centres [m]
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    /// damping: of all bodies, so that what swings comes to rest [1/s].
    Structure(std::string what, double length, double damping = 2)
        : world({.sleeping = false}), name(std::move(what)), link(length), damping_(damping) {}

    /// at: in links. It has the mass of a disc of 0.3 links, of 50 kg/m^2.
    BodyId disc(const Vec2& at, bool isHeld = false) {
        return add(at, isHeld, {.shape = Circle{0.3 * link}, .material = {.density = 50}, .filter = {.mask = 0}});
    }
    /// A bar between two places, in links.
    BodyId bar(const Vec2& from, const Vec2& to) {
        const Vec2 half = 0.5 * link * (to - from);
        return add(0.5 * (from + to), false,
                   {.shape = Capsule{-half, half, 0.05 * link}, .material = {.density = 50}, .filter = {.mask = 0}});
    }
    BodyId load(const Vec2& at, double mass) {
        const BodyId body = world.add({.position = link * at,
                                       .linearDamping = damping_,
                                       .angularDamping = damping_,
                                       .mass = Mass{mass, {0, 0}, 0.1 * mass * link * link}});
        bodies.push_back(body);
        return body;
    }
    void hinge(BodyId a, BodyId b, const Vec2& at) {
        join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = link * at}, a, b);
    }
    /// Between the bodies' centres; of a hinge and a weld, half way between them.
    void tie(LinkKind kind, BodyId a, BodyId b) {
        const Vec2 from = world.body(a).position(), to = world.body(b).position(), middle = 0.5 * (from + to);
        if (kind == LinkKind::Hinge) return hinge(a, b, middle / link);
        if (kind == LinkKind::Weld) return join(WeldJointDef{.bodyA = a, .bodyB = b, .anchor = middle}, a, b);
        DistanceJointDef rod{.bodyA = a, .bodyB = b, .anchorA = from, .anchorB = to};
        if (kind == LinkKind::Rope) rod.spring = Spring{}, rod.maxLength = (to - from).norm();
        join(rod, a, b);
    }
    void spring(BodyId a, BodyId b, const Spring& spring) {
        join(DistanceJointDef{.bodyA = a,
                              .bodyB = b,
                              .anchorA = world.body(a).position(),
                              .anchorB = world.body(b).position(),
                              .spring = spring},
             a, b);
    }

    double gap() const {
        double widest = 0;
        for (const JointId joint : joints) widest = std::max(widest, std::fabs(world.joint(joint).error()));
        return widest;
    }
    double speed() const {
        double fastest = 0;
        for (const BodyId body : bodies) fastest = std::max(fastest, world.body(body).velocity().norm());
        return fastest;
    }
    /// Is it swept, not solved at once? Its bodies are numbered as in an island; of joints only what they connect
    /// counts.
    bool isSwept() const {
        std::map<BodyId, std::uint32_t> number;
        std::uint32_t moved = 0, all = 0;
        std::vector<LaidJoint> laid;
        const auto give = [&](bool toMoved, std::uint32_t& next) {
            for (const Pair& pair : pairs_)
                for (const BodyId body : {pair.a, pair.b})
                    if (isMoved(body) == toMoved && number.try_emplace(body, next).second) ++next;
        };
        give(true, moved);
        all = moved;
        give(false, all);
        for (const Pair& pair : pairs_) {
            LaidJoint& joint = laid.emplace_back(LaidJoint{JointForm(AnchorPair{}), {}});
            joint.form.holdPoint();
            joint.link[0] = {number.at(pair.a), number.at(pair.b)};
        }
        IslandLayouts layouts;
        return layouts.find(moved, all, true, laid)->isSwept;
    }

private:
    struct Pair {
        BodyId a, b;
    };

    BodyId add(const Vec2& at, bool isHeld, const ShapeDef& shape) {
        bodies.push_back(world.add({.type = isHeld ? BodyType::Static : BodyType::Dynamic,
                                    .position = link * at,
                                    .linearDamping = damping_,
                                    .angularDamping = damping_,
                                    .shapes = {shape}}));
        return bodies.back();
    }
    void join(const JointDef& def, BodyId a, BodyId b) {
        joints.push_back(world.join(def));
        pairs_.push_back({a, b});
    }
    bool isMoved(BodyId body) const { return world.body(body).type() == BodyType::Dynamic; }

    std::vector<Pair> pairs_;
    double damping_;
};

// Where a structure has a link, this is its length [m].

/// Bays of triangles of rods between two fixed nodes, with a load at the middle [kg].
Structure truss(double link, int bays, double load);
/// Planks between two banks, hinged, and a second row of them below, joined to the first by rods across.
Structure crossedBridge(double link, int planks, double load);
/// Rods from a hub to a rim of rods. It turns about its hub, or hangs from its rim.
Structure spokedWheel(double link, int spokes, bool hangs);
/// Discs in a grid; all of the upper row are fixed.
Structure cloth(double link, LinkKind kind, int columns, int rows);
/// Hinged discs in a grid, of which some at the middle of the upper row hang from a beam.
Structure hingedNet(double link, int columns, int rows, int hooks);
/// Rings of hinged bars; each hangs in those above it and beside it.
Structure chainMail(double link, int columns, int rows, int sides);
enum class SoftKind : std::uint8_t { SpringRing, WeldRing, SpringGrid, RodGrid, WeldGrid };
/// A ring with spokes, or a grid with diagonals, that hangs from one body.
Structure softBody(double link, SoftKind kind, int size);

/// A structure of a kind, with numbers that are drawn from the seed. isLarge: more than a test of every day should
/// take.
Structure randomStructure(std::uint64_t seed, bool isLarge);

}  // namespace plumb::test
