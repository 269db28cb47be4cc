// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cases.h"
#include "catch.h"
#include "kit/dynamics/edited.h"
#include "kit/dynamics/wrap_scenes.h"

namespace plumb::test {

namespace {

/// How far apart two worlds have come in so many steps, and whether the same things have touched.
struct Divergence {
    double farthest = 0;  ///< [m]
    bool sameTouches = true;
};

Divergence divergence(WrapScene& a, WrapScene& b, int count) {
    Divergence d;
    const std::vector<BodyId> inA = a.world.bodies(), inB = b.world.bodies();
    for (int i = 0; i < count; ++i) {
        a.step();
        b.step();
        for (std::size_t k = 0; k < inA.size(); ++k) {
            const Vec2 pa = a.world.body(inA[k]).position(), pb = b.world.body(inB[k]).position();
            d.farthest = std::max(d.farthest, (a.local(pa) - b.local(pb)).norm());
        }
    }
    d.sameTouches = a.touches == b.touches;
    return d;
}

constexpr Material elastic{.friction = 0, .restitution = 1};

struct Gas {
    World world;
    std::vector<BodyId> discs;

    double energy() const {
        return std::accumulate(discs.begin(), discs.end(), 0.0, [this](double sum, BodyId id) {
            const BodyView disc = world.body(id);
            return sum + 0.5 * disc.mass() * disc.velocity().squaredNorm();
        });
    }
    Vec2 momentum() const {
        Vec2 sum(0, 0);
        for (const BodyId id : discs) sum += world.body(id).mass() * world.body(id).velocity();
        return sum;
    }
};

/// Discs of different sizes with room between them, in a world of 10 m x 10 m, or in a closed box as large.
Gas gasOf(int count, std::uint64_t seed, bool wraps) {
    Random random(seed);
    WorldDef def{.gravity = {0, 0}};
    if (wraps) def.wrap = {.width = 10.0, .height = 10.0};
    Gas gas{World(def), {}};
    const Chain walls{.points = {{0, 0}, {0, 10}, {10, 10}, {10, 0}}, .closed = true};
    if (!wraps) gas.world.add({.type = BodyType::Static, .shapes = {ShapeDef{.shape = walls, .material = elastic}}});
    for (int i = 0; i < count; ++i) {
        const double radius = random.uniform(0.05, 0.2);
        gas.discs.push_back(gas.world.add({.position = {0.5 + i % 10, 0.5 + i / 10},
                                           .velocity = {random.uniform(-4, 5), random.uniform(-5, 4)},
                                           .shapes = {circle(radius, elastic)}}));
    }
    return gas;
}

}  // namespace

TEST_CASE("2,000 piles move across a seam, or a corner of seams, as they do far from it", "[dynamics][wrap][tiles]") {
    // Rounding is not the same everywhere. What meets corner to corner multiplies it; and where two impacts come
    // together it may decide between exact impacts and the solver, which differ: then it does so far from the seam,
    // too.
    Random random(32);
    const Wrap wrap{.width = 24.0, .height = 20.0};
    int astray = 0, unlike = 0;
    const int count = cases(2000);
    for (int i = 0; i < count; ++i) {
        const auto seam = [&] { return random.uniform(-4, 4); };
        Vec2 middle(seam(), seam());
        if (i % 3 == 1) middle.x() = 12;
        if (i % 3 == 2) middle.y() = 10;
        const std::uint64_t seed = random.bits();
        const auto from = [&](const Vec2& elsewhere) {
            WrapScene far(seed, wrap, {12, 10}), other(seed, wrap, elsewhere);
            return divergence(far, other, 40);
        };
        const Divergence across = from(middle);
        if (across.farthest < 1e-9 && across.sameTouches) continue;
        ++astray;
        double farthest = 6e-5;  // the floats of the solver, a thousand times
        for (int k = 0; k < 40; ++k)
            farthest = std::max(farthest, from({random.uniform(8, 16), random.uniform(8, 12)}).farthest);
        unlike += across.farthest <= 10 * farthest ? 0 : 1;
    }
    CHECK(unlike == 0);
    CHECK(astray <= std::max(1.0, 0.03 * count));
}

TEST_CASE("a pile in a world that wraps far from its seam moves to the last bit as in one that does not",
          "[dynamics][wrap][tiles]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        WrapScene wraps(seed, {.width = 1000.0, .height = 1000.0}, {500, 500}), open(seed, {}, {500, 500});
        for (int i = 0; i < 60; ++i) {
            wraps.step();
            open.step();
        }
        CHECK(stateHash(wraps.world) == stateHash(open.world));
        CHECK(wraps.touches == open.touches);
    }
}

TEST_CASE("an elastic gas of 20 to 100 discs across the seams keeps energy and momentum for 30 s",
          "[dynamics][wrap][tiles]") {
    for (const int count : {20, 50, 100}) {
        Gas around = gasOf(count, static_cast<std::uint64_t>(count), true);
        Gas closed = gasOf(count, static_cast<std::uint64_t>(count), false);
        const double energyAround = around.energy(), energyClosed = closed.energy();
        const Vec2 momentum = around.momentum();
        double largest = 0, driftAround = 0, driftClosed = 0, driftMomentum = 0;
        for (const BodyId id : around.discs)
            largest += around.world.body(id).mass() * around.world.body(id).velocity().norm();
        int hits = 0;
        for (int i = 0; i < 1800; ++i) {
            around.world.step(dt);
            closed.world.step(dt);
            hits += static_cast<int>(around.world.contactHits().size());
            driftAround = std::max(driftAround, std::fabs(around.energy() / energyAround - 1));
            driftClosed = std::max(driftClosed, std::fabs(closed.energy() / energyClosed - 1));
            driftMomentum = std::max(driftMomentum, (around.momentum() - momentum).norm() / largest);
        }
        INFO(count << " discs, " << hits << " hits, energy " << driftAround << " against " << driftClosed
                   << " in a closed box, momentum " << driftMomentum);
        CHECK(hits > 5 * count);
        CHECK(driftAround < 1e-9);
        CHECK(driftMomentum < 1e-9);
    }
}

TEST_CASE("a body that falls round and round a world 20 m high falls as it would for ever", "[dynamics][wrap][tiles]") {
    World world({.wrap = {.height = 20.0}});
    const BodyId ball = world.add({.position = {3, 1}, .velocity = {2, 0}, .shapes = {circle(0.2)}});
    for (int i = 1; i <= 600; ++i) {
        world.step(dt);
        const double t = i * dt, y = 1 - 0.5 * g * t * t;
        const Vec2 place = world.body(ball).position();
        REQUIRE(place.y() >= 0);
        REQUIRE(place.y() < 20);
        // Of 490 m, a rounding a step.
        CHECK(std::fabs(std::remainder(place.y() - y, 20)) < 600 * 490 * 2.3e-16);
        CHECK(std::fabs(place.x() - (3 + 2 * t)) < 1e-12);
        CHECK(world.body(ball).pose().position == place);
        CHECK(world.moves().front().pose.position == place);
    }
}

TEST_CASE("a stack of six boxes on a seam sleeps, and does not creep", "[dynamics][wrap][tiles]") {
    World world({.wrap = {.width = 12.0}});
    world.add({.type = BodyType::Static, .position = {6, 0}, .shapes = {box({3, 0.5})}});
    world.add({.type = BodyType::Static, .position = {0, 0}, .shapes = {box({3, 0.5})}});
    std::vector<BodyId> stack;
    for (int i = 0; i < 6; ++i)
        stack.push_back(world.add({.position = {i % 2 == 0 ? 0.1 : 11.95, 1 + i * 1.0}, .shapes = {box({0.5, 0.5})}}));
    steps(world, 300);
    for (std::size_t i = 0; i < stack.size(); ++i) {
        CHECK_FALSE(world.body(stack[i]).awake());
        const Vec2 start(i % 2 == 0 ? 0.1 : 11.95, 1 + static_cast<double>(i));
        CHECK(world.wrap().shortest(start, world.body(stack[i]).position()).norm() < 0.01);
    }
    CHECK_FALSE(world.body(stack[0]).contacts().empty());
    world.body(stack[5]).applyImpulse({0.5, 0});
    CHECK(world.body(stack[0]).awake());
}

TEST_CASE("a box without friction slides ten times round a floor as long as the world and loses nothing",
          "[dynamics][wrap][tiles]") {
    const Material ice{.friction = 0};
    for (const bool flat : {false, true}) {
        World world({.wrap = {.width = 20.0}});
        const Segment ground{.start = {0, 0}, .end = {20, 0}, .before = Vec2(-20, 0), .after = Vec2(40, 0)};
        world.add({.type = BodyType::Static, .shapes = {ShapeDef{.shape = ground, .material = ice}}});
        const BodyId sled = world.add({.position = {3, flat ? 0.4 : 0.5},
                                       .velocity = {6, 0},
                                       .shapes = {flat ? circle(0.4, ice) : box({0.5, 0.5}, ice)}});
        double slowest = 6, highest = 0, lowest = 1;
        for (int i = 0; i < 2000; ++i) {
            world.step(dt);
            slowest = std::min(slowest, world.body(sled).velocity().x());
            highest = std::max(highest, world.body(sled).position().y());
            lowest = std::min(lowest, world.body(sled).position().y());
        }
        // The solver's floats know 6 m/s to 5e-7.
        CHECK(std::fabs(slowest - 6) < 1e-6);
        CHECK(highest - lowest < 2e-3);
        CHECK(std::fabs(world.wrap().shortest({3 + 6 * 2000 * dt, 0}, {world.body(sled).position().x(), 0}).x()) <
              1e-3);
    }
}

TEST_CASE("a bullet of 1,000 m/s flies through the seam and stops at a wall 1 cm thick behind it",
          "[dynamics][wrap][tiles]") {
    Random random(31);
    for (int i = 0; i < cases(1000); ++i) {
        const double angle = random.uniform(-0.1, 0.1), speed = random.uniform(100, 1000);
        const bool mirrored = random.integer(0, 1) == 1, moving = random.integer(0, 1) == 1;
        const double side = mirrored ? -1 : 1;
        const Vec2 wall(side * random.uniform(0.05, 3), random.uniform(-5, 5)), from(-side * random.uniform(0.1, 4), 1);
        const auto shoot = [&](World& world, double wallHalf) {
            world.add({.type = moving ? BodyType::Kinematic : BodyType::Static,
                       .position = world.wrap().place(wall),
                       .velocity = {moving ? side * 0.5 : 0.0, 0},
                       .shapes = {box({0.005, wallHalf})}});
            return world.add({.position = world.wrap().place(from),
                              .velocity = Rot::fromAngle(angle) * Vec2(side * speed, 0),
                              .shapes = {circle(0.02)}});
        };
        World around({.gravity = {0, 0}, .wrap = {.width = 400.0, .height = 50.0}}), open({.gravity = {0, 0}});
        const BodyId bullet = shoot(around, 25), twin = shoot(open, 200);
        for (int k = 0; k < 10; ++k) {
            around.step(dt);
            open.step(dt);
            const Vec2 there = open.body(twin).position();
            INFO("case " << i << ", step " << k);
            REQUIRE(side * (there.x() - wall.x()) < 0.12);
            REQUIRE(around.wrap().shortest(there, around.body(bullet).position()).norm() < 1e-6);
        }
    }
}

TEST_CASE("a sensor at the seam is told of what comes, stays and flies right through", "[dynamics][wrap][tiles]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 30.0}});
    const BodyId gate = world.add({.type = BodyType::Static,
                                   .position = {29.9, 0},
                                   .shapes = {ShapeDef{.shape = boxPolygon({0.3, 2}), .sensor = true}}});
    const BodyId slow = world.add({.position = {1, 0.5}, .velocity = {-2, 0}, .shapes = {circle(0.1)}});
    const BodyId fast = world.add({.position = {4, -0.5}, .velocity = {-400, 0}, .shapes = {circle(0.1)}});
    int slowBegins = 0, slowEnds = 0, fastBegins = 0, fastEnds = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(dt);
        for (const SensorBegin& begin : world.sensorBegins()) {
            CHECK(begin.sensor.body == gate);
            ++(begin.visitor.body == slow ? slowBegins : fastBegins);
        }
        for (const SensorEnd& end : world.sensorEnds()) ++(end.visitor.body == slow ? slowEnds : fastEnds);
    }
    CHECK(slowBegins == 1);
    CHECK(slowEnds == 1);
    // 400 m in a world of 30 m: it has come past after 4 m, 34 m, ... 394 m.
    CHECK(fastBegins == 14);
    CHECK(fastEnds == 14);
    CHECK(world.contains(fast));
}

TEST_CASE("what goes round a world of 1 m a million times a step neither hangs nor is lost",
          "[dynamics][wrap][tiles]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 1.0, .height = 1.5}});
    const BodyId fast = world.add({.position = {0.5, 0.5}, .velocity = {6e7, 3e7}, .shapes = {circle(0.1)}});
    world.add({.type = BodyType::Static, .position = {0.1, 0.1}, .shapes = {circle(0.05)}});
    world.add({.position = {0.8, 0.9}, .angularVelocity = 1, .shapes = {circle(0.05)}});
    for (int i = 0; i < 20; ++i) {
        world.step(dt);
        const BodyView body = world.body(fast);
        CHECK_FALSE(body.quarantined());
        CHECK(world.overlapPoint(body.position()) == body.shapes());
        CHECK(world.nearest(body.position(), 0.01)->shape == body.shapes().front());
    }
}

TEST_CASE("a place may be told in any round: of poses, forces, moves and joints", "[dynamics][wrap][tiles]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 10.0, .height = 8.0}});
    const BodyId id = world.add({.position = {-1, 17}, .shapes = {box({0.5, 0.25})}});
    CHECK(world.body(id).position() == Vec2(9, 1));
    world.body(id).setPose({23, -7}, 1);
    CHECK(world.body(id).position().isApprox(Vec2(3, 1)));
    CHECK(world.body(id).centerOfMass().isApprox(Vec2(3, 1)));
    world.body(id).setPose({9.9, 7.9}, 0);
    world.body(id).setAngularVelocity(2);
    CHECK(world.body(id).velocityAt({0.4, 0.4}).isApprox(Vec2(-1, 1)));
    world.body(id).setAngularVelocity(0);
    world.body(id).applyImpulse({0, 1}, {0.4, 7.9});
    CHECK(std::fabs(world.body(id).angularVelocity() * world.body(id).inertia() - 0.5) < 1e-12);

    const BodyId lift = world.add({.type = BodyType::Kinematic, .position = {9.5, 4}, .shapes = {circle(0.1)}});
    world.body(lift).moveTo({0.5, 4}, 0, 0.5);
    CHECK(world.body(lift).velocity().isApprox(Vec2(2, 0)));
    world.step(0.5);
    CHECK(std::fabs(world.body(lift).position().x() - 0.5) < 1e-12);
}

TEST_CASE("a place 1e100 m away is in the world, too, and a sensor there sees what is near",
          "[dynamics][wrap][tiles]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 10.0, .height = 8.0}});
    ShapeDef eye = circle(0.5);
    eye.sensor = true;
    const BodyId seer = world.add({.type = BodyType::Static, .position = {5, 5}, .shapes = {eye}});
    world.body(seer).setPose({1e100, -7e15 - 3}, 0);
    const Vec2 there = world.body(seer).position();
    CHECK(there == Vec2(std::fmod(1e100, 10.0), 8 - std::fmod(7e15 + 3, 8.0)));
    const BodyId visitor = world.add({.position = there + Vec2(0, 0.6), .shapes = {circle(0.2)}});
    world.step(1.0 / 60);
    CHECK(world.sensorBegins().size() == 1);
    const double apart =
        world.distance(world.body(seer).shapes().front(), world.body(visitor).shapes().front()).separation;
    CHECK(std::fabs(apart + 0.1) < 1e-12);
}

TEST_CASE("a joint across the seam holds what it would hold elsewhere, also after its bodies were put elsewhere",
          "[dynamics][wrap][tiles]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 10.0}});
    const BodyId a = world.add({.position = {9.5, 0}, .shapes = {circle(0.2)}});
    const BodyId b = world.add({.position = {0.7, 0}, .velocity = {0, 3}, .shapes = {circle(0.2)}});
    const JointId rod = world.join(DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = {9.5, 0}, .anchorB = {0.7, 0}});
    const auto length = [&] {
        return world.wrap().shortest(world.body(a).position(), world.body(b).position()).norm();
    };
    CHECK(std::fabs(world.joint(rod).coordinate().value - 1.2) < 1e-12);
    steps(world, 120);
    CHECK(std::fabs(length() - 1.2) < 1e-3);
    // One after the other to beyond half a round.
    world.body(a).setPose({4.8, 0}, 0);
    world.body(b).setPose({6.0, 0}, 0);
    CHECK(world.joint(rod).error() < 1e-9);
    steps(world, 120);
    CHECK(std::fabs(length() - 1.2) < 1e-3);
    // It turns about a middle that goes on at half of 3 m/s.
    const Vec2 mean = 0.5 * (world.body(a).velocity() + world.body(b).velocity());
    CHECK((mean - Vec2(0, 1.5)).norm() < 1e-5);
}

TEST_CASE("what no world that wraps can take is refused by name", "[dynamics][wrap][tiles]") {
    for (const double bad : {0.0, -3.0, std::nan(""), 1e-4, 1e12})
        REQUIRE_THROWS_WITH(World({.wrap = {.width = bad}}), containsText("WorldDef.wrap.width"));
    REQUIRE_THROWS_WITH(World({.wrap = {.height = 0.0}}), containsText("WorldDef.wrap.height: 0"));
    World world({.wrap = {.width = 10.0, .height = 6.0}});
    REQUIRE_THROWS_WITH(world.add({.type = BodyType::Static, .shapes = {circle(1), box({5.1, 1})}}),
                        containsText("BodyDef.shapes[1]: 10.2 m wide, more than the world's 10 m"));
    CHECK(world.bodies().empty());
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {box({5, 1})}});
    REQUIRE_THROWS_WITH(world.body(floor).setPose({0, 0}, 1.5), containsText("Body.setPose"));
    REQUIRE_THROWS_WITH(world.add(floor, box({1, 3.1})), containsText("6.2 m high, more than the world's 6 m"));
    REQUIRE_THROWS_WITH(world.shape(world.body(floor).shapes().front()).set(box({1, 3.1})),
                        containsText("ShapeDef.shape"));
    CHECK(world.body(floor).shapes().size() == 1);
    REQUIRE_THROWS_WITH(world.castRay({0, 0}, {1e5, 0}), containsText("World.castRay: to: 100000 m is more than 1000"));
    REQUIRE_THROWS_WITH(world.overlapBox({{0, 0}, {1, 1e3}}), containsText("World.overlapBox: box"));
    REQUIRE_THROWS_WITH(world.castShape(Circle{1}, {}, {0, 1e4}), containsText("World.castShape: shift"));
    REQUIRE_THROWS_WITH(world.overlapShape(Circle{500}, {}), containsText("World.overlapShape: shape"));
}

}  // namespace plumb::test
