// SPDX-License-Identifier: MIT
#include <compare/formula/kepler.h>

#include <cmath>
#include <numbers>

#include "catch.h"

namespace plumb::compare {

// T = 2 pi sqrt(a^3 / mu), so mu = a^3 (2 pi / T)^2; the acceleration by a difference of the velocity.
TEST_CASE("an ellipse's closed form obeys the inverse square law, and sweeps even areas", "[compare][formula][law]") {
    for (const double e : {0.0, 0.3, 0.8, 0.95, 1.0}) {
        const KeplerOrbit orbit{2, e, 5};
        const double turn = 2 * std::numbers::pi / orbit.period, mu = 8 * turn * turn;
        const double area = std::sqrt(mu * 2 * (1 - e * e));
        for (double t = 0.7; t < 4.3; t += 0.1) {  // away from the near end, where e = 1 has no speed
            CAPTURE(e, t);
            const double h = 1e-5;
            const KeplerState now = keplerState(orbit, t);
            const Vec2 acceleration =
                (keplerState(orbit, t + h).velocity - keplerState(orbit, t - h).velocity) / (2 * h);
            const Vec2 speed = (keplerState(orbit, t + h).position - keplerState(orbit, t - h).position) / (2 * h);
            const double r = now.position.norm();
            CHECK((acceleration + mu / (r * r * r) * now.position).norm() < 1e-6 * mu / (r * r));
            CHECK((speed - now.velocity).norm() < 1e-6 * now.velocity.norm() + 1e-8);
            CHECK(std::abs(cross(now.position, now.velocity) - area) < 1e-9);
        }
    }
}

}  // namespace plumb::compare
