// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/random.h>
#include <plumb/space/detail/shape_radii.h>

#include "catch.h"
#include "lanes_compare.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// Sixteen pairs of boxes, some apart, some overlapping, some flush, one after the other corner to corner.
struct BoxPairs {
    std::vector<BodyMotion> motion{1};
    std::vector<BodyPlace> place{1};
    ContactBatch batch{};
    ManifoldLanes lanes{};
    PairLanes pairs{};
    Polygon a[batchLanes], b[batchLanes];
    double size[batchLanes];
};

BoxPairs randomPairs(Random& random) {
    BoxPairs pairs;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        const double scale = std::exp(random.uniform(-2, 2));
        const auto half = [&] {
            const double x = scale * random.uniform(0.2, 1);
            const double y = scale * random.uniform(0.2, 1);
            return Vec2(x, y);
        };
        const Vec2 ha = half(), hb = half();
        const bool square = random.integer(0, 2) == 0;  // most contacts of a game are between upright boxes
        const double turn = random.uniform(-std::numbers::pi, std::numbers::pi);
        const double angleA = turn;
        const double angleB = square ? turn + random.integer(0, 3) * std::numbers::pi / 2 : random.uniform(-3, 3);
        const double way = random.uniform(-std::numbers::pi, std::numbers::pi);
        const Vec2 at(1000 * random.uniform(-1, 1), 1000 * random.uniform(-1, 1));
        const Vec2 apart = (ha.norm() + hb.norm()) * random.uniform(0.2, 1.1) * Vec2(std::cos(way), std::sin(way));
        addBody(pairs, at, angleA);
        addBody(pairs, at + apart, angleB);
        pairs.batch.bodyA[lane] = pairs.pairs.bodyA[lane] = static_cast<std::uint32_t>(pairs.motion.size() - 2);
        pairs.batch.bodyB[lane] = pairs.pairs.bodyB[lane] = static_cast<std::uint32_t>(pairs.motion.size() - 1);
        pairs.a[lane] = boxPolygon(ha);
        pairs.b[lane] = boxPolygon(hb);
        pairs.size[lane] = ha.norm() + hb.norm();
        pairs.pairs.halfXA[lane] = static_cast<float>(ha.x());
        pairs.pairs.halfYA[lane] = static_cast<float>(ha.y());
        pairs.pairs.halfXB[lane] = static_cast<float>(hb.x());
        pairs.pairs.halfYB[lane] = static_cast<float>(hb.y());
    }
    return pairs;
}

/// Sixteen pairs of a disc and another shape, in either order.
struct DiscPairs {
    std::vector<BodyMotion> motion{1};
    std::vector<BodyPlace> place{1};
    ContactStore store;
    PairLanes pairs{};
    std::vector<Convex> a, b;
    double size[batchLanes];

    CornerTable corners() const { return {store.corners.data(), store.moreCorners.data()}; }
};

/// A polygon of three to eight corners around a centre, or a capsule or a segment, at any angle.
ShapeDef slantedShape(Random& random, double scale, const Vec2& center) {
    const Vec2 end = scale * Vec2(random.uniform(0.2, 1), random.uniform(-1, 1));
    const double radius = scale * random.uniform(0.1, 0.5);
    const int corners = random.integer(1, 8);
    if (corners == 1) return {.shape = Segment{.start = center - end, .end = center + end}};
    if (corners == 2) return {.shape = Capsule{.start = center - end, .end = center + end, .radius = radius}};
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const Vec2 corner = Rot::fromAngle(2 * std::numbers::pi * i / corners) * end;
        polygon.vertices.push_back(center + Vec2(corner.x(), 0.5 * corner.y()));
    }
    polygon.radius = random.integer(0, 1) == 0 ? radius : 0;
    return {.shape = polygon};
}

ShapeDef straightShape(Random& random, double scale, const Vec2& center) {
    const Vec2 half = scale * Vec2(random.uniform(0.2, 1), 1);
    const double radius = scale * random.uniform(0.1, 0.5);
    switch (random.integer(0, 4)) {
        case 0: return {.shape = boxPolygon(half, center)};
        case 1: {
            Polygon rounded = boxPolygon(half, center);
            rounded.radius = radius;
            return {.shape = rounded};
        }
        case 2: return {.shape = Circle{.radius = scale, .center = center}};
        case 3:
            return {.shape = Capsule{
                        .start = center - Vec2(half.x(), 0), .end = center + Vec2(half.x(), 0), .radius = radius}};
        default: return {.shape = Segment{.start = center - Vec2(0, half.y()), .end = center + Vec2(0, half.y())}};
    }
}

/// Shapes whose bodies have their centres of mass at their origins. Bodies and proxies of a lane follow those of the
/// lane before it.
void fillOne(ContactStore& store, PairLanes& pairs, std::uint32_t lane, const ShapeDef& a, const ShapeDef& b) {
    ContactRecord contact;
    contact.proxyA = 2 * lane;
    contact.proxyB = 2 * lane + 1;
    contact.bodyA = 2 * lane + 1;
    contact.bodyB = 2 * lane + 2;
    setOutline(store, contact.proxyA, boxOutlineOf(a, {0, 0}), convexOf(a.shape, {0, 0}));
    setOutline(store, contact.proxyB, boxOutlineOf(b, {0, 0}), convexOf(b.shape, {0, 0}));
    fillPair(store, contact, pairs, lane);
}

Shape anyShape(Random& random) {
    const auto point = [&] {
        const double x = random.uniform(-1, 1);
        return Vec2(x, random.uniform(-1, 1));
    };
    const Vec2 first = point(), second = point(), third = point(), fourth = point();
    switch (random.integer(0, 3)) {
        case 0: return Circle{.radius = random.uniform(0.1, 1), .center = first};
        case 1: return Capsule{.start = first, .end = second, .radius = random.uniform(0.05, 0.5)};
        case 2: return Segment{.start = first, .end = second};
        default: return hullOf(std::vector<Vec2>{first, second, third, fourth});
    }
}

DiscPairs randomDiscPairs(Random& random) {
    DiscPairs pairs;
    for (std::uint32_t lane = 0; lane < batchLanes; ++lane) {
        const double scale = std::exp(random.uniform(-2, 2));
        const auto offset = [&] {
            const double x = scale * random.uniform(-1, 1);
            return Vec2(x, scale * random.uniform(-1, 1));
        };
        const Vec2 centerA = offset(), centerB = offset();  // of the shapes, from their centres of mass
        const ShapeDef disc{.shape = Circle{.radius = scale * random.uniform(0.1, 1), .center = centerA}};
        const bool straight = random.integer(0, 1) == 0;
        const ShapeDef other = straight ? straightShape(random, scale, centerB) : slantedShape(random, scale, centerB);
        const double way = random.uniform(-std::numbers::pi, std::numbers::pi);
        const double angleA = random.uniform(-3, 3), angleB = random.uniform(-3, 3);
        const Vec2 at(1000 * random.uniform(-1, 1), 1000 * random.uniform(-1, 1));
        const Vec2 apart = scale * random.uniform(0, 2.2) * Vec2(std::cos(way), std::sin(way));
        const bool discFirst = random.integer(0, 1) == 0;
        const ShapeDef& a = discFirst ? disc : other;
        const ShapeDef& b = discFirst ? other : disc;
        const Vec2& ca = discFirst ? centerA : centerB;
        const Vec2& cb = discFirst ? centerB : centerA;
        addBody(pairs, at - Rot::fromAngle(angleA) * ca, angleA);
        addBody(pairs, at + apart - Rot::fromAngle(angleB) * cb, angleB);
        fillOne(pairs.store, pairs.pairs, lane, a, b);
        pairs.a.push_back(convexOf(a.shape, {0, 0}));
        pairs.b.push_back(convexOf(b.shape, {0, 0}));
        pairs.size[lane] = 6 * scale;
    }
    return pairs;
}

Manifold oneByOne(const DiscPairs& pairs, std::size_t lane) {
    return manifold(pairs.a[lane], pairs.b[lane], relativePose(pairs.motion[2 * lane + 1], pairs.motion[2 * lane + 2]),
                    contactMargin);
}

Manifold oneByOne(const BoxPairs& pairs, std::size_t lane) {
    return manifold(convexOf(pairs.a[lane], {0, 0}), convexOf(pairs.b[lane], {0, 0}),
                    relativePose(pairs.motion[pairs.batch.bodyA[lane]], pairs.motion[pairs.batch.bodyB[lane]]),
                    contactMargin);
}

/// A batch whose lanes touch bodies of their own, with numbers as a pile has them.
struct Pile {
    std::vector<SolverVelocity> velocity, warm, before;
    std::vector<SolverDisplacement> displacement;
    std::vector<SolverTurn> turn;
    std::vector<Kick> kick;
    ContactBatch batch{};

    SolverBodies bodies() {
        return {velocity.data(), warm.data(), before.data(), displacement.data(), turn.data(), kick.data()};
    }
};

Pile randomPile(Random& random) {
    constexpr std::size_t count = 1 + 2 * batchLanes;
    Pile pile;
    const auto number = [&](double reach) { return static_cast<float>(random.uniform(-reach, reach)); };
    pile.velocity.resize(count);
    pile.warm.resize(count);
    pile.before.resize(count);
    pile.displacement.resize(count);
    pile.turn.resize(count);
    pile.kick.resize(count);
    for (std::size_t i = 1; i < count; ++i) {
        pile.velocity[i] = {number(3), number(3), number(3), static_cast<float>(random.uniform(0.1, 5))};
        pile.displacement[i] = {number(0.1), number(0.1), number(0.1), number(0.01)};
    }
    ContactBatch& batch = pile.batch;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        const bool onGround = random.integer(0, 3) == 0;
        batch.bodyA[lane] = onGround ? 0 : static_cast<std::uint32_t>(1 + 2 * lane);
        batch.bodyB[lane] = static_cast<std::uint32_t>(2 + 2 * lane);
        const double angle = random.uniform(-3, 3);
        batch.normalX[lane] = static_cast<float>(std::cos(angle));
        batch.normalY[lane] = static_cast<float>(std::sin(angle));
        batch.friction[lane] = static_cast<float>(random.uniform(0, 1));
        batch.roundA[lane] = batch.roundB[lane] = random.integer(0, 1) == 0 ? 0 : 0.5f;
        batch.surfaceSpeed[lane] = number(1);
        batch.rollingArm[lane] = static_cast<float>(random.uniform(0, 0.2));
        batch.rollInverseGyrationA[lane] = batch.rollInverseGyrationB[lane] =
            static_cast<float>(random.uniform(0.5, 2));
        batch.rollMass[lane] = static_cast<float>(random.uniform(0.1, 1));
        for (PointLanes& p : batch.points) {
            p.anchorNormalA[lane] = number(1);
            p.anchorTangentA[lane] = number(1);
            p.anchorNormalB[lane] = number(1);
            p.anchorTangentB[lane] = number(1);
            p.startSeparation[lane] = p.separation[lane] = number(0.02);
            const SolverVelocity &a = pile.velocity[batch.bodyA[lane]], &b = pile.velocity[batch.bodyB[lane]];
            const float armA = p.anchorTangentA[lane], armB = p.anchorTangentB[lane];
            p.normalMass[lane] = 1 / (a.inverseMass * (1 + armA * armA) + b.inverseMass * (1 + armB * armB));
            p.tangentMass[lane] = static_cast<float>(random.uniform(0.05, 0.5));
            p.normalImpulse[lane] = static_cast<float>(random.uniform(0, 1));
            p.tangentImpulse[lane] = number(0.5);
            p.bounceSpeed[lane] = random.integer(0, 1) == 0 ? 0 : 1.0f;
        }
    }
    batch.bounces = true;
    batch.hasSurfaceSpeed = random.integer(0, 1) == 1;
    batch.hasRollingResistance = random.integer(0, 1) == 1;
    return pile;
}

void solveAll(const ContactSolver& solver, Pile& pile) {
    const ContactPass pass{240, softness(30, 10, 1.0 / 240), 3};
    solver.gatherWarmStart(&pile.batch, batchLanes, pile.bodies());
    for (int i = 0; i < 4; ++i) {
        solver.solve(&pile.batch, batchLanes, pile.bodies(), pass);
        solver.relax(&pile.batch, batchLanes, pile.bodies(), pass);
    }
    solver.bounce(&pile.batch, batchLanes, pile.bodies());
}

/// As in two steps: what the first one leaves says which contacts rest, and which impulses they keep.
void prepareTwice(const LaneCollider& collider, BoxPairs& pairs, const std::vector<SolverVelocity>& velocity,
                  const FreshLanes& fresh, const StepLength& step, std::uint64_t seed) {
    Random random(seed);
    const BodyPlace* place = pairs.place.data();
    collider.prepare(pairs.batch, pairs.lanes, place, velocity.data(), fresh, {60, 1, 8}, batchLanes);
    for (PointLanes& p : pairs.batch.points)
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            p.totalNormal[lane] = static_cast<float>(random.uniform(-0.5, 2));
            p.totalTangent[lane] = static_cast<float>(random.uniform(-0.5, 0.5));
            p.anchorTangentA[lane] += static_cast<float>(random.uniform(-0.05, 0.05));
            p.normalImpulse[lane] = static_cast<float>(random.uniform(0, 1));
        }
    collider.prepare(pairs.batch, pairs.lanes, place, velocity.data(), fresh, step, batchLanes);
}

}  // namespace

TEST_CASE("boxes side by side have the manifolds that they have one by one, in 10,000 placements",
          "[dynamics][lanes][property]") {
    Random random(11);
    Agreement agreement;
    for (int round = 0; round < 10'000 / batchLanes; ++round) {
        const BoxPairs pairs = randomPairs(random);
        FreshLanes fresh{};
        laneCollider(1).collideBoxes(pairs.pairs, pairs.place.data(), fresh, batchLanes);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            INFO("round " << round << ", lane " << lane);
            // along a face a turn of 1e-7 moves a cut by as much again
            const float tolerance = static_cast<float>(4e-6 * pairs.size[lane]);
            compare(oneByOne(pairs, lane), manifoldIn(fresh, lane), {tolerance, 3 * tolerance, 0.99999f}, agreement);
        }
    }
    CHECK(agreement.touching > 5'000);
    // where two faces do equally well, or a point is at the margin or the corner
    CHECK(agreement.otherwise < agreement.touching / 100);
}

TEST_CASE("discs side by side have the manifolds that they have one by one, in 20,000 placements",
          "[dynamics][lanes][property]") {
    Random random(13);
    Agreement agreement;
    for (int round = 0; round < 20'000 / batchLanes; ++round) {
        const DiscPairs pairs = randomDiscPairs(random);
        FreshLanes fresh{};
        laneCollider(1).collideDiscs(pairs.pairs, pairs.place.data(), pairs.corners(), fresh, batchLanes);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            INFO("round " << round << ", lane " << lane);
            const float tolerance = static_cast<float>(4e-6 * pairs.size[lane]);
            compare(oneByOne(pairs, lane), manifoldIn(fresh, lane), {tolerance, 10 * tolerance, 0.9999f}, agreement);
        }
        for (const int lanes : {4, 8, 16}) {
            FreshLanes again{};
            laneCollider(lanes).collideDiscs(pairs.pairs, pairs.place.data(), pairs.corners(), again, batchLanes);
            CHECK(sameBits(again, fresh));
        }
    }
    CHECK(agreement.touching > 10'000);
    // where the centre lies inside, or before a corner, as far from two faces
    CHECK(agreement.otherwise < agreement.touching / 100);
}

TEST_CASE("of 10,000 shapes that meet another in the step none is passed over because of its box",
          "[dynamics][lanes][property]") {
    Random random(14);
    int met = 0, passedOver = 0;
    for (int round = 0; round < 10'000; ++round) {
        const Shape a = anyShape(random), b = anyShape(random);
        std::vector<BodyPlace> place(3);
        BodyMotion still, moving;
        moving.center = {random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5)};
        moving.angle = random.uniform(-3, 3);
        moving.rotation = Rot::fromAngle(moving.angle);
        const Vec2 shift = random.uniform(0, 1) * Vec2(random.uniform(-4, 4), random.uniform(-4, 4));
        const double turn = random.uniform(-1, 1);
        place[1] = placeOf(still, 1);
        place[2] = placeOf(moving, 1);
        place[2].shiftX = static_cast<float>(shift.x());
        place[2].shiftY = static_cast<float>(shift.y());
        place[2].turn = static_cast<float>(std::fabs(turn) * turningRadiusOf(b, {0, 0}));
        ContactStore store;
        PairLanes pairs{};
        fillOne(store, pairs, 0, {.shape = a}, {.shape = b});
        FreshLanes fresh{};
        laneCollider(1).collideBoxes(pairs, place.data(), fresh, batchLanes);
        bool meets = false;
        for (int i = 0; i <= 20; ++i) {
            const Transform pose{moving.center + shift * (i / 20.0), Rot::fromAngle(moving.angle + turn * i / 20.0)};
            meets = meets || distance(a, {}, b, pose).separation < 0;
        }
        met += meets ? 1 : 0;
        passedOver += fresh.count[0] == 0 ? 1 : 0;
        INFO("round " << round);
        if (meets) CHECK(fresh.count[0] > 0);
    }
    CHECK(met > 2'000);
    CHECK(passedOver > 2'000);
}

TEST_CASE("manifolds and what the solver needs of them are the same bits at 1, 4, 8 and 16 lanes",
          "[dynamics][lanes][property]") {
    Random random(12);
    for (int round = 0; round < 1'000; ++round) {
        const BoxPairs pairs = randomPairs(random);
        std::vector<SolverVelocity> velocity(pairs.motion.size());
        for (SolverVelocity& v : velocity) {
            v.x = static_cast<float>(random.uniform(-5, 5));
            v.y = static_cast<float>(random.uniform(-5, 5));
            v.w = static_cast<float>(random.uniform(-5, 5));
            v.inverseMass = static_cast<float>(random.uniform(0, 5));
        }
        const StepLength step{60, random.integer(0, 1) == 0 ? 1 : static_cast<float>(random.uniform(0.1, 10)), 8};
        FreshLanes first{};
        BoxPairs prepared = pairs;
        laneCollider(1).collideBoxes(pairs.pairs, pairs.place.data(), first, batchLanes);
        prepareTwice(laneCollider(1), prepared, velocity, first, step, static_cast<std::uint64_t>(round));
        for (const int lanes : {4, 8, 16}) {
            FreshLanes fresh{};
            BoxPairs again = pairs;
            laneCollider(lanes).collideBoxes(pairs.pairs, pairs.place.data(), fresh, batchLanes);
            prepareTwice(laneCollider(lanes), again, velocity, fresh, step, static_cast<std::uint64_t>(round));
            INFO("round " << round << ", " << lanes << " lanes");
            CHECK(sameBits(fresh, first));
            CHECK(std::memcmp(&again.batch, &prepared.batch, offsetof(ContactBatch, bounces)) == 0);
            CHECK(sameBits(again.lanes, prepared.lanes));
        }
    }
}

TEST_CASE("contacts are solved to the same bits one by one and at 4, 8 and 16 lanes", "[dynamics][lanes][property]") {
    for (std::uint64_t seed = 0; seed < 1'000; ++seed) {
        Random random(seed);
        const Pile start = randomPile(random);
        Pile reference = start;
        solveAll(contactSolver(1), reference);
        for (const int lanes : {4, 8, 16}) {
            Pile pile = start;
            solveAll(contactSolver(lanes), pile);
            INFO("seed " << seed << ", " << lanes << " lanes");
            CHECK(std::memcmp(&pile.batch, &reference.batch, offsetof(ContactBatch, bounces)) == 0);
            for (std::size_t i = 0; i < pile.velocity.size(); ++i)
                CHECK(sameBits(pile.velocity[i], reference.velocity[i]));
        }
    }
}
