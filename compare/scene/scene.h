// SPDX-License-Identifier: MIT
// What is put into each engine, what is watched, and what must be true?
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
    double appears = 0;  ///< neither the body nor its joints exist before this time; >= 0 [s]
    double renewed = 0;  ///< it is removed and made anew each time it has existed for so long; 0: never [s]
};

struct SceneJoint {
    std::string name{};              ///< unique in the scene
    std::string bodyA{}, bodyB{};    ///< names; a target has a bodyA only, and a gear neither
    JointDef def{};                  ///< its ids are left empty; each engine fills in its own
    std::string jointA{}, jointB{};  ///< names of earlier joints: those that a gear couples
};

struct SceneField {
    std::string name{};  ///< unique in the scene
    FieldDef def{};      ///< a magnet's id is left empty; each engine fills in its own
    std::string body{};  ///< the name of the body that carries a magnet
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
/// By how much a hinge, a slide or a wheel is beyond its limit; 0 within it [rad or m].
struct LimitProbe {
    std::string joint{};
};
/// 1 once the joint has broken, 0 before.
struct JointBrokenProbe {
    std::string joint{};
};
/// How often something has entered a sensor of the body, since the start.
struct SensorCountProbe {
    std::string body{};
};

/// The number of steps so far in which the body lost more than drop of its speed along a direction: it got caught.
struct SnagsProbe {
    std::string body{};
    Vec2 direction{1, 0};  ///< a unit vector [-]
    double drop = 0.01;    ///< > 0 [m/s]
};

/// How far the origin of body B is from that of body A along a direction [m].
struct ApartProbe {
    std::string bodyA{}, bodyB{};  ///< from A to B
    Vec2 direction{1, 0};          ///< a unit vector [-]
};

/// Which values between from and until are compared with the expected one?
enum class Watch {
    Every,    ///< each of them
    Largest,  ///< the one farthest from zero: for how far a swing goes
    Last,     ///< the last one: for where it ends up
};

using Quantity = std::variant<AngleProbe, NormalForceProbe, JointForceProbe, PositionProbe, VelocityProbe, LimitProbe,
                              JointBrokenProbe, SensorCountProbe, SnagsProbe, ApartProbe>;

/// A quantity watched in addition to the positions. Its metric is probe.<name>: the largest distance from expected.
struct Probe {
    std::string name{};
    Quantity quantity{};
    double expected = 0;         ///< in the quantity's unit; not used if the closed form gives the angle
    double from = 0;             ///< watched from this time on: before it the scene settles [s]
    std::string unit{};          ///< "rad", "N"
    double until = 0;            ///< watched until this time; 0: to the end [s]
    Watch watch = Watch::Every;  ///< which values count
};

/// As which number is a field shown to a person? A vector as one of its coordinates, or by its length or direction.
enum class ShownAs {
    Number,       ///< as it is
    Downwards,    ///< with the other sign
    PerSecond,    ///< 1 over it: how many in a second
    X,            ///< of a vector
    Y,            ///< of a vector
    Size,         ///< length of a vector, measured from SceneControl::about
    Direction,    ///< of a vector, from the x axis [degrees]
    Hanging,      ///< of a vector measured from SceneControl::about: from straight down [degrees]
    Degrees,      ///< of an angle [degrees]
    DegreesDown,  ///< with the other sign [degrees]
};

/// A number of the scene that a page offers to a person to change.
struct SceneControl {
    std::string label{};             ///< what it is
    std::vector<std::string> set{};  ///< the paths that get the value, as in set_field.h; the first one is shown
    ShownAs as = ShownAs::Number;
    Vec2 about{0, 0};         ///< from where a vector is measured
    double from = 0, to = 1;  ///< as the person sees it; from < to
    double step = 0.01;       ///< > 0
    std::string unit{};       ///< "m/s"
};

/// Values, as JSON, that are for one engine alone: by engine, and by the path of a field as in set_field.h. A path that
/// starts with "solver." is a number of the engine itself.
using EngineSettings = std::map<std::string, std::map<std::string, std::string>>;

struct Scene {
    std::string name{};      ///< snake_case
    std::string title{};     ///< for a reader; "": made from the name
    std::string group{};     ///< the heading under which it is listed; "": among the other scenes
    std::string question{};  ///< what it asks, one sentence
    std::string answer{};    ///< values of a run are put in for the queries between braces: see answer.h
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    double duration = 2;     ///< [s]
    double dt = 1.0 / 60;    ///< [s]
    bool sleeping = true;    ///< may engines skip bodies at rest?
    Wrap wrap{};             ///< does it continue at the opposite side?
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    std::vector<SceneField> fields{};
    std::vector<SceneMover> movers{};
    std::optional<ClosedForm> closedForm{};
    std::vector<Probe> probes{};
    std::vector<Check> checks{};
    std::vector<SceneControl> controls{};
    EngineSettings engines{};
};

/// True if it is there from the start of the scene to its end.
inline bool isAlwaysThere(const SceneBody& body) {
    return body.appears == 0 && body.renewed == 0;
}

/// True if a shape bounces. Engines with a restitution threshold are then run with a threshold of 0.
bool bounces(const Scene& scene);

/// Its title, or one made from its name: free_fall becomes "Free fall".
std::string titleOf(const Scene& scene);

/// round(duration / dt).
int stepCount(const Scene& scene);

/// The metrics that its checks may name: error_max and error_end where there is a closed form, divergence_max,
/// divergence_time, energy_drift, momentum_drift, angular_momentum_drift, penetration_max, joint_error_max,
/// settle_time, ms_per_step, and probe.<name> for each probe.
std::vector<std::string> checkableMetrics(const Scene& scene);

/// Throws std::invalid_argument naming the field, the value and what was wanted: names that are missing, used twice or
/// unknown, impossible numbers, metrics that do not exist.
void validate(const Scene& scene);

}  // namespace plumb::compare
