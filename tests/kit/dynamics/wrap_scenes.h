// SPDX-License-Identifier: MIT
// What is the same wherever it happens, in a world that wraps? A few bodies of every kind, seeded.
#pragma once
#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

namespace plumb::test {

/// A pile on a floor in a box of 8 m x 8 m around a middle, some of it joined, with a sensor and a paddle.
class WrapScene {
public:
    WrapScene(std::uint64_t seed, const Wrap& around, const Vec2& middle)
        : wrap(around), world({.gravity = {0, -9.81}, .wrap = around}), random_(seed), middle_(middle) {
        const Material rough{.friction = 0.6, .restitution = random_.uniform(0, 0.4)};
        world.add({.type = BodyType::Static, .position = at({0, -3}), .shapes = {box({3.5, 0.25}, rough)}});
        world.add({.type = BodyType::Static, .position = at({-3.4, -1}), .shapes = {segment({0, -2}, {0, 2}, rough)}});
        world.add({.type = BodyType::Kinematic,
                   .position = at({random_.uniform(1, 3), -2.4}),
                   .velocity = {random_.uniform(-1.5, 0), 0},
                   .shapes = {box({0.2, 0.3}, rough)}});
        world.add({.type = BodyType::Static,
                   .position = at({random_.uniform(-2, 2), -2}),
                   .shapes = {ShapeDef{.shape = Circle{1.0}, .sensor = true}}});
        const int count = random_.integer(3, 8);
        std::vector<BodyId> bodies;
        for (int i = 0; i < count; ++i) bodies.push_back(addBody(i, rough));
        for (int i = random_.integer(0, 2); i > 0; --i) join(bodies);
    }

    /// Any of the places that are the same.
    Vec2 at(const Vec2& local) { return wrap.place(middle_ + local); }
    /// From the middle, the short way.
    Vec2 local(const Vec2& place) const { return wrap.shortest(middle_, place); }

    void step() {
        world.step(1.0 / 60);
        const auto name = [](const ShapeId& id) { return std::tuple(id.body.index, id.number); };
        for (const ContactBegin& begin : world.contactBegins())
            touches.emplace(std::min(name(begin.shapeA), name(begin.shapeB)),
                            std::max(name(begin.shapeA), name(begin.shapeB)));
        for (const SensorBegin& begin : world.sensorBegins()) touches.emplace(name(begin.sensor), name(begin.visitor));
    }

    Wrap wrap;
    World world;
    std::set<std::pair<std::tuple<std::uint32_t, std::uint32_t>, std::tuple<std::uint32_t, std::uint32_t>>> touches;

private:
    BodyId addBody(int i, const Material& rough) {
        const Vec2 place(random_.uniform(-2.8, 2.8), -2.3 + 0.75 * i + random_.uniform(0, 0.2));
        const double size = random_.uniform(0.2, 0.35);
        ShapeDef shape = circle(size, rough);
        switch (random_.integer(0, 3)) {
            case 0: shape = box({size, 0.7 * size}, rough); break;
            case 1: shape = capsule({-size, 0}, {size, 0}, 0.5 * size, rough); break;
            case 2: shape = polygon({{-size, -size}, {size, -size}, {0, size}}, rough); break;
            default: break;
        }
        return world.add({.position = at(place),
                          .angle = random_.uniform(-3, 3),
                          .velocity = {random_.uniform(-2, 2), random_.uniform(-2, 1)},
                          .angularVelocity = random_.uniform(-1, 1),
                          .shapes = {shape}});
    }
    void join(const std::vector<BodyId>& bodies) {
        const int last = static_cast<int>(bodies.size()) - 1;
        const int first = random_.integer(0, last - 1);
        const BodyId a = bodies[static_cast<std::size_t>(first)], b = bodies[static_cast<std::size_t>(first + 1)];
        const Vec2 pa = local(world.body(a).position()), pb = local(world.body(b).position());
        switch (random_.integer(0, 5)) {
            case 0: world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = at(0.5 * (pa + pb))}); break;
            case 1: world.join(DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = at(pa), .anchorB = at(pb)}); break;
            case 2: world.join(WeldJointDef{.bodyA = a, .bodyB = b, .anchor = at(0.5 * (pa + pb))}); break;
            case 3: world.join(MotorJointDef{.bodyA = a, .bodyB = b, .maxForce = 20, .maxTorque = 5}); break;
            case 4: world.join(TargetJointDef{.body = a, .anchor = at(pa), .target = at({0, 1})}); break;
            default:
                world.join(PulleyJointDef{.bodyA = a,
                                          .bodyB = b,
                                          .groundA = at(pa + Vec2(0, 1)),
                                          .groundB = at(pb + Vec2(0, 1)),
                                          .anchorA = at(pa),
                                          .anchorB = at(pb)});
        }
    }

    Random random_;
    Vec2 middle_;
};

}  // namespace plumb::test
