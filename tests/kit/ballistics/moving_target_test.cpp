// SPDX-License-Identifier: MIT
#include <plumb/ballistics/moving_target.h>

#include <vector>

#include <plumb/ballistics/beam.h>
#include <plumb/ballistics/fixed_speed.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

namespace {

using namespace plumb::test;
using namespace plumb;

std::string textOfMovingAim(const MovingAim& problem) {
    return describe("target", problem.target, "at", problem.targetVelocity, "shooter at", problem.shooterVelocity,
                    "speed", problem.speed, "gravity", problem.gravity);
}

MovingAim randomChase(Random& random) {
    MovingAim problem;
    problem.speed = magnitude(random, 1, 300);
    problem.gravity = randomGravity(random);
    const double range = problem.speed * problem.speed / problem.gravity.norm();
    problem.target = towards(random.uniform(-pi, pi), range * magnitude(random, 1e-2, 3));
    problem.targetVelocity = towards(random.uniform(-pi, pi), problem.speed * magnitude(random, 0.01, 3));
    if (random.integer(0, 1) == 0)
        problem.shooterVelocity = towards(random.uniform(-pi, pi), problem.speed * magnitude(random, 0.01, 1));
    return problem;
}

/// How far the target is from all that the shot can reach at a time, over what either goes: in the frame that
/// falls with the shot and flies with the shooter, where shots go straight and the target rises.
double gapAt(Real t, const MovingAim& problem) {
    const auto part = [&](auto get) {
        return get(problem.target) + t * (Real(get(problem.targetVelocity)) - get(problem.shooterVelocity)) -
               t * t / 2 * get(problem.gravity);
    };
    const Point p{part([](const Vec2& v) { return v.x(); }), part([](const Vec2& v) { return v.y(); })};
    const Real reach = problem.speed * t;
    return static_cast<double>((length(p) - reach) / (length(p) + reach));
}

/// Times when the gap changes its sign, in steps of 1/200 of a decade around the time scales of the problem.
int crossings(const MovingAim& problem) {
    const double scale = problem.target.norm() / problem.speed;
    int count = 0;
    bool outside = true;
    for (double t = 1e-3 * scale; t < 1e7 * scale; t *= 1.0115794542598985) {
        const double gap = gapAt(t, problem);
        if (std::fabs(gap) < 1e-17) continue;  // rounding's, where the two only touch
        const bool now = gap > 0;
        count += now != outside;
        outside = now;
    }
    return count;
}

}  // namespace

// Worked numbers of the firing solution, "no gravity, d = (30, 10), w = (-4, 3)", v = 20 m/s.
TEST_CASE("at 20 m/s a target from (30 m, 10 m) at (-4, 3) m/s is met after 1.4105352667 s", "[ballistics][facts]") {
    const MovingAim problem{.target = {30, 10}, .targetVelocity = {-4, 3}, .speed = 20, .gravity = {0, 0}};
    const std::vector<Shot> shots = aimAtMoving(problem);
    REQUIRE(shots.size() == 1);
    CHECK(std::fabs(shots[0].time - 1.4105352667) < 5e-11);
    CHECK(std::fabs(shots[0].velocity.x() - 17.268521751) < 5e-10);
    CHECK(std::fabs(shots[0].velocity.y() - 10.089507250) < 5e-10);
}

TEST_CASE("a million shots at moving targets hit, and a scan over time finds no other", "[ballistics][shots]") {
    Random random(157);
    Worst miss("moving target: miss / path of both"), speed("moving target: speed off, relative");
    Worst gap("moving target: by time and distance alone");
    int counts[5] = {}, disorder = 0, fewer = 0, scanned = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const MovingAim problem = randomChase(random);
        const auto where = [&] { return textOfMovingAim(problem); };
        const std::vector<Shot> shots = aimAtMoving(problem);
        ++counts[shots.size()];
        for (std::size_t k = 0; k < shots.size(); ++k) {
            const Shot& shot = shots[k];
            disorder += k > 0 && shot.time < shots[k - 1].time;
            const Vec2 end = problem.target + shot.time * problem.targetVelocity;
            const double path = pathLength(shot, problem.gravity) + (end - problem.target).norm();
            miss.hold(missAtTime(shot, end, problem.gravity) / path, where);
            const double all = problem.speed + problem.shooterVelocity.norm();
            speed.hold(std::fabs((shot.velocity - problem.shooterVelocity).norm() - problem.speed) / all, where);
            gap.hold(std::fabs(gapAt(shot.time, problem)), where);
        }
        // A scan of 3,200 times costs more than a hundred solutions: one problem in fifty has it.
        if (i % 50 != 0) continue;
        ++scanned;
        fewer += static_cast<std::size_t>(crossings(problem)) > shots.size();
    }
    for (const Worst* worst : {&miss, &speed, &gap}) worst->print();
    std::cout << "moving target: problems with 0 to 4 shots:";
    for (const int count : counts) std::cout << ' ' << count;
    std::cout << "; " << scanned << " scanned\n";
    CHECK(miss.value() < 1e-9);
    CHECK(speed.value() < 1e-12);
    CHECK(gap.value() < 1e-12);
    CHECK(disorder == 0);
    CHECK(fewer == 0);
    for (const int k : {0, 2, 4}) CHECK(counts[k] > 0);  // odd ones only where two come together
}

TEST_CASE("at a target that stands still it is aim(), and without gravity the first is aimBeam(), 100,000 times",
          "[ballistics][shots]") {
    Random random(163);
    Worst still("moving target that stands: time off, relative"), beam("moving target, no gravity: time off, relative");
    int differ = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        MovingAim problem = randomChase(random);
        const auto where = [&] { return textOfMovingAim(problem); };
        problem.shooterVelocity = {0, 0};
        const Vec2 velocity = problem.targetVelocity;
        problem.targetVelocity = {0, 0};
        // Away from the limit of the range, where times are roots of small differences.
        if (std::fabs(beyondReach(problem.speed, problem.target, problem.gravity)) > 1e-3) {
            const std::vector<Shot> shots = aimAtMoving(problem);
            const std::vector<Shot> others = aim({problem.target, problem.speed, problem.gravity});
            differ += shots.size() != others.size();
            for (std::size_t k = 0; k < std::min(shots.size(), others.size()); ++k)
                still.hold(std::fabs(shots[k].time / others[k].time - 1), where);
        }
        problem.targetVelocity = velocity;
        // By the closed form, or with the gravity that is lost in rounding within any time to a target of these.
        problem.gravity = random.integer(0, 1) * magnitude(random, 1e-60, 1e-25) * problem.gravity;
        const double aside = std::fabs(cross(problem.target.normalized(), velocity));
        if (std::fabs(aside / problem.speed - 1) < 1e-3) continue;
        // As fast as the shot, to the last place; not straight away, where no time is long enough.
        const bool asFast = random.integer(0, 3) == 0;
        if (asFast) problem.targetVelocity *= problem.speed / velocity.norm();
        if (asFast && problem.targetVelocity.normalized().dot(problem.target.normalized()) > -1e-3) continue;
        const std::vector<Shot> shots = aimAtMoving(problem);
        const std::optional<Shot> other = aimBeam({problem.target, problem.targetVelocity, {0, 0}, problem.speed});
        // What no beam meets, a lob may, after 1e25 s and more.
        if (other || problem.gravity.isZero(0)) differ += shots.empty() == other.has_value();
        if (other && !shots.empty()) beam.hold(std::fabs(shots[0].time / other->time - 1), where);
    }
    still.print();
    beam.print();
    CHECK(differ == 0);
    CHECK(still.value() < 1e-10);
    CHECK(beam.value() < 1e-10);
}

TEST_CASE("a target as fast as the shot is met, whether gravity is none, next to none, or some", "[ballistics]") {
    // From (5, -1) at (-1, 0) m/s, shots of 1 m/s: (5 - t)^2 + 1 = t^2.
    for (const double gravity : {0.0, 5e-324, 1e-60, 1e-45, 1e-30, 1e-25, 1e-20, 1e-16, 1e-12}) {
        const std::vector<Shot> shots =
            aimAtMoving({.target = {5, -1}, .targetVelocity = {-1, 0}, .speed = 1, .gravity = {0, -gravity}});
        REQUIRE(!shots.empty());
        CHECK(std::fabs(shots[0].time - 2.6) < 1e-14 + 10 * gravity);
    }
    // Small whole numbers, which make the coincidences that others never do, against a scan over time.
    Random random(167);
    int fewer = 0, asFast = 0;
    Worst gap("moving target, whole numbers: by time and distance alone");
    for (int i = 0; i < cases(20'000); ++i) {
        const auto whole = [&](int most) { return static_cast<double>(random.integer(-most, most)); };
        MovingAim problem{.speed = std::fabs(whole(8)), .gravity = {0, 0}};
        problem.target = {whole(6), whole(6)};
        problem.targetVelocity = {whole(4), whole(4)};
        if (random.integer(0, 1) == 0) problem.gravity = {0.5 * whole(1), -0.5 * std::fabs(whole(4))};
        if (problem.target.isZero() || problem.speed == 0) continue;
        asFast += problem.targetVelocity.norm() == problem.speed;
        const std::vector<Shot> shots = aimAtMoving(problem);
        for (const Shot& shot : shots)
            gap.hold(std::fabs(gapAt(shot.time, problem)), [&] { return textOfMovingAim(problem); });
        fewer += shots.size() < static_cast<std::size_t>(crossings(problem));
    }
    gap.print();
    CHECK(asFast > cases(20'000) / 100);
    CHECK(fewer == 0);
    CHECK(gap.value() < 1e-12);
}

TEST_CASE("a target dropped as the shot leaves is hit by pointing at it, and the shooter's speed is the shot's",
          "[ballistics]") {
    // The monkey and the hunter: in the frame that falls with both the shot goes straight. Here gravity is the
    // shot's alone, so the target that stands still is the one that has to be led.
    const std::vector<Shot> still = aimAtMoving({.target = {30, 5}, .targetVelocity = {0, 0}, .speed = 20});
    REQUIRE(still.size() == 2);
    CHECK(std::fabs(still[0].time - 1.8582692722) < 5e-11);  // Worked numbers of the firing solution, low arc
    CHECK(std::fabs(still[1].time - 3.3367464652) < 5e-11);
    // Shooter and target at the same velocity see the same: so does the shot.
    const std::vector<Shot> both =
        aimAtMoving({.target = {30, 5}, .targetVelocity = {7, -2}, .shooterVelocity = {7, -2}, .speed = 20});
    REQUIRE(both.size() == 2);
    CHECK(both[0].time == still[0].time);
    CHECK((both[0].velocity - still[0].velocity - Vec2(7, -2)).norm() < 1e-14);
    CHECK(aimAtMoving({.target = {0, 0}, .shooterVelocity = {1, 0}, .speed = 5}).front().velocity == Vec2(1, 5));
    CHECK_THROWS_WITH(aimAtMoving({.target = {1, 0}, .targetVelocity = {0, 1e99}, .speed = 5}),
                      containsText("MovingAim.targetVelocity: 1e+99 is not within"));
}
