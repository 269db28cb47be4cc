// SPDX-License-Identifier: MIT
// What is put into each engine, what is watched, and what must hold?
#pragma once
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <compare/scene/check.h>
#include <compare/scene/closed_form.h>
#include <compare/scene/mover.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/field_def.h>
#include <plumb/dynamics/joint_def.h>
#include <plumb/space/wrap.h>

namespace plumb::compare {

struct SceneBody {
    std::string name{};  ///< unique in the scene
    BodyDef def{};
    double appears = 0;  ///< not there before this, as its joints are not; >= 0 [s]
    double renewed = 0;  ///< taken out and made anew each time so long after it appeared; 0: never [s]
};

struct SceneJoint {
    std::string name{};              ///< unique in the scene
    std::string bodyA{}, bodyB{};    ///< names; a target has a bodyA only, and a gear neither
    JointDef def{};                  ///< its ids are left empty; each engine fills in its own
    std::string jointA{}, jointB{};  ///< names of joints before it: what a gear couples
};

struct SceneField {
    std::string name{};  ///< unique in the scene
    FieldDef def{};      ///< a magnet's id is left empty; each engine fills in its own
    std::string body{};  ///< the name of what carries a magnet
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

/// How far the body's origin lies along a direction, from the world's origin [m].
struct PositionProbe {
    std::string body{};
    Vec2 direction{0, 1};  ///< a unit vector [-]
};
/// How fast the body's centre of mass moves along a direction [m/s].
struct VelocityProbe {
    std::string body{};
    Vec2 direction{1, 0};  ///< a unit vector [-]
};
/// By how much a hinge, a slide or a wheel is beyond its limit, 0 within [rad or m].
struct LimitProbe {
    std::string joint{};
};
/// 1 once the joint has broken, 0 before.
struct JointBrokenProbe {
    std::string joint{};
};
/// How often something has come into a sensor of the body, since the start.
struct SensorCountProbe {
    std::string body{};
};

/// In how many steps so far the body has lost more than drop of its speed along a direction: what caught it.
struct SnagsProbe {
    std::string body{};
    Vec2 direction{1, 0};  ///< a unit vector [-]
    double drop = 0.01;    ///< > 0 [m/s]
};

/// By how much the origin of one body is beyond another's along a direction [m].
struct ApartProbe {
    std::string bodyA{}, bodyB{};  ///< from A to B
    Vec2 direction{1, 0};          ///< a unit vector [-]
};

/// Which of its values between from and until are held against what is expected?
enum class Watch {
    Every,    ///< each of them
    Largest,  ///< the one farthest from zero: how far a swing goes
    Last,     ///< what it comes to
};

using Quantity = std::variant<AngleProbe, NormalForceProbe, JointForceProbe, PositionProbe, VelocityProbe, LimitProbe,
                              JointBrokenProbe, SensorCountProbe, SnagsProbe, ApartProbe>;

/// A quantity watched beside the positions; its metric is probe.<name>, the largest distance from expected.
struct Probe {
    std::string name{};
    Quantity quantity{};
    double expected = 0;         ///< in the quantity's unit; ignored where the closed form gives every angle then
    double from = 0;             ///< watched from here: before it the scene settles [s]
    std::string unit{};          ///< "rad", "N"
    double until = 0;            ///< to here; 0: to the end [s]
    Watch watch = Watch::Every;  ///< which values count
};

/// By engine, and by the path of a field as set_field.h has it, the value that this engine alone is given, as JSON. A
/// path that starts with "solver." is a number of the engine's own.
using EngineSettings = std::map<std::string, std::map<std::string, std::string>>;

struct Scene {
    std::string name{};      ///< snake_case
    std::string title{};     ///< as a reader sees it; "": made of the name
    std::string group{};     ///< the heading under which it is listed; "": among others
    std::string question{};  ///< what it asks, one sentence
    std::string answer{};    ///< with what is to be read of a run between braces: see answer.h
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    double duration = 2;     ///< [s]
    double dt = 1.0 / 60;    ///< [s]
    bool sleeping = true;    ///< may engines leave out what rests?
    Wrap wrap{};             ///< does it go on at its other side?
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    std::vector<SceneField> fields{};
    std::vector<SceneMover> movers{};
    std::optional<ClosedForm> closedForm{};
    std::vector<Probe> probes{};
    std::vector<Check> checks{};
    EngineSettings engines{};
};

/// It is there from the start of the scene to its end.
inline bool isAlwaysThere(const SceneBody& body) {
    return body.appears == 0 && body.renewed == 0;
}

/// A shape bounces: engines that have a restitution threshold are then run with one of 0.
bool bounces(const Scene& scene);

/// Its title, or one made of its name: free_fall is "Free fall".
std::string titleOf(const Scene& scene);

/// round(duration / dt).
int stepCount(const Scene& scene);

/// Throws std::invalid_argument naming the field, the value and what was wanted: names that are missing, used twice or
/// unknown, impossible numbers, metrics that do not exist.
void validate(const Scene& scene);

}  // namespace plumb::compare
