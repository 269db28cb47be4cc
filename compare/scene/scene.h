// SPDX-License-Identifier: MIT
// What is put into each engine, what is watched, and what must hold?
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <compare/scene/check.h>
#include <compare/scene/closed_form.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/joint_def.h>

namespace plumb::compare {

struct SceneBody {
    std::string name{};  ///< unique in the scene
    BodyDef def{};
};

struct SceneJoint {
    std::string name{};            ///< unique in the scene
    std::string bodyA{}, bodyB{};  ///< names
    JointDef def{};                ///< its ids are left empty; each engine fills in its own
};

/// The body's angle [rad].
struct AngleProbe {
    std::string body{};
};
/// How hard two bodies press on each other: the sum of their contact's normal forces [N].
struct NormalForceProbe {
    std::string bodyA{}, bodyB{};
};
/// The size of the force in a joint [N].
struct JointForceProbe {
    std::string joint{};
};

/// A quantity watched beside the positions; its metric is probe.<name>, the largest distance from expected.
struct Probe {
    std::string name{};
    std::variant<AngleProbe, NormalForceProbe, JointForceProbe> quantity{};
    double expected = 0;  ///< in the quantity's unit; ignored where the closed form gives the angle then
    double from = 0;      ///< watched from here, to the end: before it the scene settles [s]
    std::string unit{};   ///< "rad", "N"
};

struct Scene {
    std::string name{};      ///< snake_case
    std::string question{};  ///< what it asks, one sentence
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    double duration = 2;     ///< [s]
    double dt = 1.0 / 60;    ///< [s]
    bool sleeping = true;    ///< may engines leave out what rests?
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    std::optional<ClosedForm> closedForm{};
    std::vector<Probe> probes{};
    std::vector<Check> checks{};
};

/// A shape bounces: Box2D is then run with a restitution threshold of 0.
bool bounces(const Scene& scene);

/// round(duration / dt).
int stepCount(const Scene& scene);

/// Throws std::invalid_argument naming the field, the value and what was wanted: names that are missing, used twice or
/// unknown, impossible numbers, metrics that do not exist.
void validate(const Scene& scene);

}  // namespace plumb::compare
