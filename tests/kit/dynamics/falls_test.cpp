// SPDX-License-Identifier: MIT
// What flies at corners, edges and rough ground: is it never left in the air, and does it never gain energy?
#include <algorithm>
#include <cmath>
#include <string>

#include "cases.h"
#include "catch.h"
#include "kit/dynamics/grounds.h"

namespace plumb::test {

namespace {

constexpr double rates[] = {30, 60, 120};

/// What went wrong in one fall, and when; empty if nothing did.
class RoughFall {
public:
    explicit RoughFall(unsigned seed) : random_(seed) {
        world_.setGravity({0, random_.integer(0, 1) == 0 ? 0 : -9.81});
        const auto kind = roughGrounds[random_.integer(0, 4)];
        const double friction = random_.integer(0, 2) == 0 ? 0 : random_.uniform(0, 1);
        ground_ = addGround(world_, kind, random_, friction);
        dt_ = 1 / rates[random_.integer(0, 2)];
        const double speed = 5 * std::exp(random_.uniform(0, std::log(20))), angle = random_.uniform(-2.4, -0.7);
        const double restitution = random_.integer(0, 2) == 0 ? random_.uniform(0, 1) : 0;
        body_ = world_.add({.position = {random_.uniform(-5, 5), random_.uniform(3, 6)},
                            .angle = random_.uniform(-3, 3),
                            .velocity = {speed * std::cos(angle), speed * std::sin(angle)},
                            .angularVelocity = random_.uniform(-10, 10),
                            .shapes = {randomFaller(random_, {.friction = friction, .restitution = restitution})}});
    }

    std::string run() {
        const int ticks = static_cast<int>(std::lround(1.5 / dt_));
        const double first = energyNow();
        double energy = first;
        int kept = 0;
        for (int tick = 0; tick < ticks; ++tick) {
            const Body body = world_.body(body_);
            const Vec2 at = body.position(), velocity = body.velocity();
            const double angle = body.angle();
            world_.step(dt_);
            if (std::fabs(body.position().x()) > 15) return "";  // it has left the ground
            const bool moved = (body.position() - at).norm() > 1e-9 || std::fabs(body.angle() - angle) > 1e-9;
            const bool touches = !body.contacts().empty();
            kept = !moved && !touches && body.velocity().norm() > 1 ? kept + 1 : 0;
            if (kept == 2) return "hangs" + when(tick);
            if (ground_.isBelow(world_, body.position())) return "went through" + when(tick);
            if (!touches && (body.velocity() - velocity - world_.gravity() * dt_).norm() > 1e-3 * (1 + velocity.norm()))
                return "was pushed without a contact" + when(tick);
            const double now = energyNow();
            if (now > first + 1e-3) return "has more energy than at first" + when(tick);
            // Contacts are straight in a step: what turns around a corner at 30 Hz gains up to a few per cent.
            if (now > energy + 0.05 * first + 1e-3) return "gained energy" + when(tick);
            energy = std::min(energy, now);
        }
        return "";
    }

private:
    std::string when(int tick) const { return " at step " + std::to_string(tick); }
    double energyNow() const {
        const BodyView body = world_.body(body_);
        return 0.5 * body.mass() * body.velocity().squaredNorm() +
               0.5 * body.inertia() * body.angularVelocity() * body.angularVelocity() -
               body.mass() * world_.gravity().dot(body.centerOfMass());
    }

    World world_;
    Random random_;
    Ground ground_;
    BodyId body_;
    double dt_ = 0;
};

}  // namespace

TEST_CASE("what flies at walls is never left in the air", "[dynamics][falls]") {
    for (int seed = 1; seed <= cases(5000); ++seed) {
        INFO("seed " << seed);
        CHECK(RoughFall(static_cast<unsigned>(seed)).run() == "");
    }
}

}  // namespace plumb::test
