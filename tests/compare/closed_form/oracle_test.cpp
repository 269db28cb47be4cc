// SPDX-License-Identifier: MIT
#include <compare/closed_form/oracle.h>

#include <cmath>
#include <limits>

#include <compare/check/verdict.h>
#include <compare/engine/engine.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

Scene sceneOf(const BodyMotion& motion) {
    Scene scene;
    scene.bodies = {{"ground", {.type = BodyType::Static}}, {"ball", {}}};
    scene.closedForm = ClosedForm{.bodies = {motion}};
    return scene;
}

BodyState ballAt(const Scene& scene, double t) {
    return closedFormStates(scene, t).at(1);
}

bool unknown(const BodyState& state) {
    for (const double number : {state.position.x(), state.position.y(), state.angle, state.velocity.x(),
                                state.velocity.y(), state.angularVelocity})
        if (!std::isnan(number)) return false;
    return true;
}

const PiecewiseMotion twoFlights{"ball",
                                 {{.position = {1, 2}, .velocity = {3, 4}, .acceleration = {0, -10}},
                                  {.start = 1,
                                   .position = {4, 1},
                                   .velocity = {-1, 0},
                                   .angle = 0.5,
                                   .angularVelocity = 2,
                                   .angularAcceleration = -4}}};

}  // namespace

TEST_CASE("a shot of 20 m/s at 45 degrees lands at 40.774719674 m after 2.8832080782 s, at most 10.193679918 m high",
          "[compare][closed_form][law]") {
    const Scene scene = findScene("projectile").value();
    // Worked numbers of the firing solution, v = 20 exact limit: nine decimals of metres, ten of seconds, times 20 m/s.
    const Vec2 landing = closedFormStates(scene, 2.8832080782).at(0).position;
    CHECK(std::abs(landing.x() - 40.774719674) < 2e-9);
    CHECK(std::abs(landing.y()) < 2e-9);
    const BodyState apex = closedFormStates(scene, 2.8832080782 / 2).at(0);
    CHECK(std::abs(apex.position.y() - 10.193679918) < 1e-9);
    CHECK(std::abs(apex.velocity.y()) < 1e-9);
}

TEST_CASE("a shot of 20 m/s at 45 degrees with k = 0.2 lands at 29.091533064 m after 2.6501815833 s",
          "[compare][closed_form][law]") {
    const Scene scene = findScene("projectile_damped").value();
    // Worked numbers of the firing solution, k = 0.2: range, flight time, apex and its time.
    const Vec2 landing = closedFormStates(scene, 2.6501815833).at(0).position;
    CHECK(std::abs(landing.x() - 29.091533064) < 2e-9);
    CHECK(std::abs(landing.y()) < 2e-9);
    const BodyState apex = closedFormStates(scene, 1.2666983553).at(0);
    CHECK(std::abs(apex.position.y() - 8.5791237899) < 1e-9);
    CHECK(std::abs(apex.velocity.y()) < 1e-9);
}

TEST_CASE("a ball dropped from 20 m has fallen 4.905 m after 1 s", "[compare][closed_form][law]") {
    const BodyState state = closedFormStates(findScene("free_fall").value(), 1).at(0);
    CHECK(std::abs(state.position.y() - 15.095) < 1e-14);
    CHECK(std::abs(state.velocity.y() + 9.81) < 1e-14);
}

TEST_CASE("flights follow each other at their starts", "[compare][closed_form]") {
    const Scene scene = sceneOf(twoFlights);
    CHECK(ballAt(scene, 0).position == Vec2(1, 2));
    CHECK(ballAt(scene, 0.5).position == Vec2(2.5, 2 + 2 - 1.25));
    CHECK(ballAt(scene, 0.5).velocity == Vec2(3, -1));
    // At the instant itself the next one holds.
    CHECK(ballAt(scene, 1).velocity == Vec2(-1, 0));
    const BodyState later = ballAt(scene, 1.5);
    CHECK(later.position == Vec2(3.5, 1));
    CHECK(later.angle == 0.5 + 1 - 0.5);
    CHECK(later.angularVelocity == 0);
}

TEST_CASE("a flight 0.001 m/s faster is seen as 0.001 m after 1 s", "[compare][closed_form]") {
    Scene scene = findScene("head_on_1").value();
    scene.closedForm = workedOut(scene);
    const Vec2 before = closedFormStates(scene, 1.775).at(1).position;  // 1 s after the impact
    auto& motion = std::get<PiecewiseMotion>(scene.closedForm->bodies.at(1));
    motion.flights.at(1).velocity.x() += 0.001;
    const Vec2 after = closedFormStates(scene, 1.775).at(1).position;
    CHECK(std::abs((after - before).x() - 0.001) < 1e-14);
}

TEST_CASE("the closed form says nothing of other bodies, nor past its end", "[compare][closed_form]") {
    Scene scene = sceneOf(twoFlights);
    CHECK_FALSE(unknown(closedFormStates(scene, 0.5).at(0)));  // static
    scene.bodies.at(0).def.type = BodyType::Kinematic;
    CHECK(unknown(closedFormStates(scene, 0.5).at(0)));
    CHECK_FALSE(unknown(ballAt(scene, 100)));
    scene.closedForm->until = 2;
    CHECK_FALSE(unknown(ballAt(scene, 2)));
    CHECK_FALSE(unknown(ballAt(scene, 20 * 0.1 + 1e-15)));  // a tick's time, rounded up
    CHECK(unknown(ballAt(scene, 2.001)));
    scene.closedForm.reset();
    CHECK(closedFormStates(scene, 0).size() == 2);
    CHECK(unknown(ballAt(scene, 0)));
}

TEST_CASE("a spring that hangs from a static body has its energy in the closed form, too", "[compare][closed_form]") {
    const Scene scene = findScene("spring_undamped").value();
    RunOptions options;
    options.engines = {"closed-form"};
    const SceneResult result = runScene(scene, options, engines());
    CHECK(result.engines.at(0).measured.metrics.at("energy_drift").value() < 1e-12);
}

TEST_CASE("a motion of a body that is not there is refused by name", "[compare][closed_form][errors]") {
    const Scene scene = sceneOf(PiecewiseMotion{"bell", {{}}});
    std::string message;
    try {
        closedFormStates(scene, 0);
    } catch (const std::invalid_argument& error) {
        message = error.what();
    }
    CHECK(message == "closedForm.bodies: \"bell\" is not the name of a body");
}

TEST_CASE("a pendulum's body turns with its rod, or keeps its angle", "[compare][closed_form]") {
    PendulumMotion motion{.body = "ball", .pivot = {1, 2}, .length = 0.5, .amplitude = 0.5, .bodyAngle = 0.2};
    const BodyState start = ballAt(sceneOf(motion), 0);
    // 1e-15 to rounding: sin 0.5, cos 0.5
    CHECK((start.position - Vec2(1 + 0.5 * 0.479425538604203, 2 - 0.5 * 0.8775825618903728)).norm() < 1e-15);
    CHECK(std::abs(start.angle - 0.2) < 1e-15);
    CHECK(start.velocity.norm() < 1e-15);
    const BodyState turned = ballAt(sceneOf(motion), 0.3);
    CHECK(turned.angle < 0.2);
    CHECK(turned.angularVelocity < 0);
    motion.turns = false;
    const BodyState kept = ballAt(sceneOf(motion), 0.3);
    CHECK(kept.angle == 0.2);
    CHECK(kept.angularVelocity == 0);
    CHECK(kept.position == turned.position);
}

TEST_CASE("a body with drag turns as its own definition says", "[compare][closed_form]") {
    Scene scene = sceneOf(DampedFlight{.body = "ball", .damping = 1});
    scene.bodies[1].def.angle = 1;
    scene.bodies[1].def.angularVelocity = 2;
    CHECK(ballAt(scene, 3).angle == 7);
    scene.bodies[1].def.angularDamping = 0.5;
    // 1 + 2 (1 - e^-1.5) / 0.5
    CHECK(std::abs(ballAt(scene, 3).angle - 4.107479359406281) < 1e-14);
    CHECK(std::abs(ballAt(scene, 3).angularVelocity - 2 * 0.22313016014842982) < 1e-15);
}

TEST_CASE("in every built-in closed form the velocity is the rate of the position", "[compare][closed_form][law]") {
    int looked = 0;
    for (Scene scene : builtinScenes()) {
        if (!scene.closedForm) continue;
        scene.closedForm = workedOut(scene);
        for (int i = 1; i < 200; ++i) {
            const double t = scene.duration * i / 200.37;
            const double h = 1e-4;
            const auto before = closedFormStates(scene, t - h);
            const auto now = closedFormStates(scene, t);
            const auto after = closedFormStates(scene, t + h);
            for (std::size_t b = 0; b < now.size(); ++b) {
                // Where the speed changes at once an impact lies between.
                const bool impact = (after[b].velocity - before[b].velocity).norm() > 0.02;
                if (unknown(now[b]) || impact) continue;
                ++looked;
                INFO(scene.name << ", " << scene.bodies[b].name << " at t = " << t);
                // h^2 / 6 times a third derivative, at most 300 m/s^3, is 5e-7; rounding, 1e-14 / h, is far less.
                CHECK(((after[b].position - before[b].position) / (2 * h) - now[b].velocity).norm() < 1e-6);
                CHECK(std::abs((after[b].angle - before[b].angle) / (2 * h) - now[b].angularVelocity) < 1e-6);
            }
        }
    }
    CHECK(looked > 4000);
}

TEST_CASE("a pendulum on one side only hangs still while another swings for it, and both make one whole swing",
          "[compare][closed_form]") {
    const PendulumMotion whole{.body = "ball", .pivot = {1, 2}, .length = 1, .amplitude = -0.5};
    PendulumMotion left = whole, right = whole;
    left.side = Side::Left;
    right.side = Side::Right;
    for (double t = 0; t < 5; t += 0.05) {
        const BodyState state = ballAt(sceneOf(whole), t);
        const bool isLeft = state.position.x() < 1;
        CHECK((ballAt(sceneOf(isLeft ? left : right), t).position - state.position).norm() < 1e-14);
        const BodyState still = ballAt(sceneOf(isLeft ? right : left), t);
        CHECK((still.position - Vec2(1, 1)).norm() < 1e-15);
        CHECK(still.velocity == Vec2(0, 0));
        CHECK(still.angularVelocity == 0);
    }
    // A body's angle is what it is at the start: this one hangs still then.
    CHECK(ballAt(sceneOf(right), 0).angle == 0);
    CHECK(ballAt(sceneOf(left), 0).angle == 0);
}

TEST_CASE("a pendulum hit at 0.4 s hangs until then, and is up at its amplitude a quarter of a period later",
          "[compare][closed_form]") {
    PendulumMotion hit{.body = "ball", .pivot = {0, 1}, .length = 1, .amplitude = 0.5, .turns = false};
    hit.from = 0.4;
    CHECK(ballAt(sceneOf(hit), 0.3).position == Vec2(0, 0));
    const BodyState moving = ballAt(sceneOf(hit), 0.4 + 1e-9);
    // v^2 = 2 g l (1 - cos 0.5), to the right
    CHECK(std::abs(moving.velocity.x() - std::sqrt(2 * 9.81 * (1 - std::cos(0.5)))) < 1e-8);
    const double quarter = 2.0060666807 / 4 * 1.0158534;  // T0 of 1 m; AGM(1, cos 0.25) by hand
    CHECK(std::abs(ballAt(sceneOf(hit), 0.4 + quarter).position.x() - std::sin(0.5)) < 1e-6);
    hit.approach = {3, 0};  // what hits it comes at 3 m/s
    CHECK((ballAt(sceneOf(hit), 0.1).position - Vec2(-0.9, 0)).norm() < 1e-15);
    CHECK(ballAt(sceneOf(hit), 0.1).velocity == Vec2(3, 0));
}

TEST_CASE("an oscillator moves along its direction about where it rests", "[compare][closed_form]") {
    const OscillatorMotion motion{
        .body = "ball", .rest = {1, 2}, .direction = {0.6, 0.8}, .offset = 0.5, .mass = 1, .stiffness = 4};
    const BodyState half = ballAt(sceneOf(motion), 3.141592653589793 / 2);  // half of a period of pi
    CHECK((half.position - Vec2(0.7, 1.6)).norm() < 1e-14);
    const BodyState quarter = ballAt(sceneOf(motion), 3.141592653589793 / 4);
    CHECK((quarter.velocity - Vec2(-0.6, -0.8)).norm() < 1e-14);  // 0.5 times 2 rad/s
}

// Terminal speed sqrt(9.81 / 0.005); worked numbers computed to 30 digits.
TEST_CASE("what falls with drag is at 25.748172225 m/s after 3 s, 41.234527650 m down",
          "[compare][closed_form][facts]") {
    const DragFall motion{.body = "ball", .position = {1, 2}, .terminalSpeed = std::sqrt(9.81 / 0.005)};
    const BodyState state = ballAt(sceneOf(motion), 3);
    CHECK(std::abs(state.velocity.y() + 25.748172225) < 1e-9);
    CHECK((state.position - Vec2(1, 2 - 41.234527650)).norm() < 1e-9);
}

TEST_CASE("an ellipse in the world has its near end where it is said to be, and drifts", "[compare][closed_form]") {
    const KeplerMotion motion{.body = "ball",
                              .focus = {1, 2},
                              .drift = {0.5, 0},
                              .nearEnd = {0, 1},
                              .semiMajorAxis = 2,
                              .eccentricity = 0.5,
                              .period = 8,
                              .since = 4};
    CHECK((ballAt(sceneOf(motion), 0).position - Vec2(1, -1)).norm() < 1e-12);  // the far end, 3 m below the focus
    CHECK((ballAt(sceneOf(motion), 4).position - Vec2(3, 3)).norm() < 1e-12);   // the near end, 1 m above it
}

}  // namespace plumb::compare
