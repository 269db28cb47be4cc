// SPDX-License-Identifier: MIT
// Which fields has each part of a scene, and what are they called in a file?
// One list a type, for reader and writer alike, so that they cannot differ: of what the kit defines, its description.
// A visitor offers
//   visit("name", field)                a field,
//   visit.orInfinite("name", field)     a number that may be infinite, of either sign,
//   visit.shape(shape)                  a shape under its kind: "circle": {...},
//   visit.oneOf(variant, tags)          one alternative of a variant under its tag.
#pragma once
#include <array>
#include <span>
#include <type_traits>
#include <variant>

#include <compare/scene/scene.h>
#include <plumb/dynamics/describe.h>
#include <plumb/shapes/tile_text.h>

namespace plumb::compare {

// What the enumerators are called in a file, in their order.
inline constexpr std::array<const char*, 3> sideTags{"both", "left", "right"};
inline constexpr std::array<const char*, 3> watchTags{"every", "largest", "last"};
inline constexpr std::array<const char*, 4> directionTags{"up", "left", "down", "right"};
inline constexpr std::array<const char*, 3> easingTags{"none", "acceleration", "smoothStep"};
inline constexpr std::array<const char*, 3> repeatTags{"once", "loop", "backAndForth"};
inline constexpr std::array<const char*, 2> styleTags{"modern", "1985"};
inline constexpr std::array<const char*, 2> standInTags{"kinematic", "stopped"};
constexpr std::span<const char* const> tagsOf(Direction) {
    return directionTags;
}
constexpr std::span<const char* const> tagsOf(Easing) {
    return easingTags;
}
constexpr std::span<const char* const> tagsOf(PathRepeat) {
    return repeatTags;
}
constexpr std::span<const char* const> tagsOf(PlatformStyle) {
    return styleTags;
}
constexpr std::span<const char* const> tagsOf(StandIn) {
    return standInTags;
}
constexpr std::span<const char* const> tagsOf(Side) {
    return sideTags;
}
constexpr std::span<const char* const> tagsOf(Watch) {
    return watchTags;
}

inline constexpr std::array motionTags{"piecewise", "damped", "pendulum", "oscillator", "dragFall", "kepler"};
inline constexpr std::array moverTags{"path", "slide", "grid", "platform", "swing"};
inline constexpr std::array probeTags{"angle", "normalForce", "jointForce",  "position", "velocity",
                                      "limit", "jointBroken", "sensorCount", "snags",    "apart"};
inline constexpr std::array checkTags{"exact", "agree", "invariant", "order"};

// Of a number without bound, for which JSON has no sign.
inline constexpr const char* infiniteTag = "infinite";
inline constexpr const char* minusInfiniteTag = "-infinite";

template <class T>
inline constexpr bool isVariant = false;
template <class... T>
inline constexpr bool isVariant<std::variant<T...>> = true;

/// Tells a visitor of fields of the members of a kit's definition. Ids are left out, for a scene has names, and so is
/// code.
template <class Visit>
struct MemberFields {
    Visit& visit;

    template <class T>
    void operator()(const Member& member, T& value) const {
        using Value = std::remove_const_t<T>;
        if constexpr (std::is_same_v<Value, Shape>)
            visit.shape(value);
        else if constexpr (isVariant<Value>)
            visit.oneOf(value, tagsOfAlternatives<Value>);
        else if constexpr (std::is_same_v<Value, double>)
            member.allowed.infinite || member.allowed.minusInfinite ? visit.orInfinite(member.name, value)
                                                                    : visit(member.name, value);
        else if constexpr (!std::is_same_v<Value, BodyId> && !std::is_same_v<Value, JointId> &&
                           !std::is_same_v<Value, ContactRule>)
            visit(member.name, value);
    }
};

/// What the kit describes; but a magnet's pull is part of its own object.
template <Described Def>
requires(!OrConst<Def, Magnet>) void fields(auto& visit, Def& def) {
    describe(def, MemberFields<std::remove_reference_t<decltype(visit)>>{visit});
}
void fields(auto& visit, OrConst<Magnet> auto& x) {
    fields(visit, x.pull);
}
void fields(auto& visit, OrConst<Shape> auto& x) {
    visit.shape(x);
}
/// A box as a file may give it; it is kept as the polygon it is.
struct BoxFields {
    Vec2 halfSize{0.5, 0.5};  ///< [m]
    Vec2 center{0, 0};        ///< [m]
    double radius = 0;        ///< the outline lies so far outside of the box [m]
};
void fields(auto& visit, OrConst<BoxFields> auto& x) {
    visit("halfSize", x.halfSize);
    visit("center", x.center);
    visit("radius", x.radius);
}
/// A tile map as a file gives it.
struct TilesFields {
    std::vector<std::string> rows = {};  ///< the topmost first, in the letters of the standard legend
    double size = 1;                     ///< of a tile [m]
    bool wrapX = false;
    bool wrapY = false;
};
void fields(auto& visit, OrConst<TilesFields> auto& x) {
    visit("rows", x.rows);
    visit("size", x.size);
    visit("wrapX", x.wrapX);
    visit("wrapY", x.wrapY);
}
void fields(auto& visit, OrConst<SceneBody> auto& x) {
    visit("name", x.name);
    visit("appears", x.appears);
    visit("renewed", x.renewed);
    fields(visit, x.def);
}
void fields(auto& visit, OrConst<SceneJoint> auto& x) {
    visit("name", x.name);
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
    visit("jointA", x.jointA);
    visit("jointB", x.jointB);
    visit.oneOf(x.def, tagsOfAlternatives<JointDef>);
}
void fields(auto& visit, OrConst<SceneField> auto& x) {
    visit("name", x.name);
    visit("body", x.body);
    fields(visit, x.def);
}
void fields(auto& visit, OrConst<Cell> auto& x) {
    visit("column", x.column);
    visit("row", x.row);
}
void fields(auto& visit, OrConst<PathMotion> auto& x) {
    visit("points", x.points);
    visit("spline", x.spline);
    visit("closed", x.closed);
    visit("delay", x.delay);
    visit("speed", x.speed);
    visit("acceleration", x.acceleration);
    visit("easing", x.easing);
    visit("repeat", x.repeat);
}
void fields(auto& visit, OrConst<SlidingMotion> auto& x) {
    visit("velocity", x.velocity);
    visit("pushStrength", x.pushStrength);
    visit("standIn", x.standIn);
}
void fields(auto& visit, OrConst<GridMotion> auto& x) {
    visit("map", x.map);
    visit("cell", x.cell);
    visit("heading", x.heading);
    visit("speed", x.speed);
    visit("turns", x.turns);
}
void fields(auto& visit, OrConst<PlatformCue> auto& x) {
    visit("time", x.time);
    visit("move", x.move);
    visit("run", x.run);
    visit("jump", x.jump);
}
void fields(auto& visit, OrConst<PlatformMotion> auto& x) {
    visit("profile", x.profile);
    visit("cues", x.cues);
}
void fields(auto& visit, OrConst<SwingMotion> auto& x) {
    visit("amplitude", x.amplitude);
    visit("rate", x.rate);
}
void fields(auto& visit, OrConst<SceneMover> auto& x) {
    visit("name", x.name);
    visit("body", x.body);
    visit.oneOf(x.motion, moverTags);
}
void fields(auto& visit, OrConst<Flight> auto& x) {
    visit("start", x.start);
    visit("position", x.position);
    visit("velocity", x.velocity);
    visit("acceleration", x.acceleration);
    visit("angle", x.angle);
    visit("angularVelocity", x.angularVelocity);
    visit("angularAcceleration", x.angularAcceleration);
}
void fields(auto& visit, OrConst<PiecewiseMotion> auto& x) {
    visit("body", x.body);
    visit("flights", x.flights);
}
void fields(auto& visit, OrConst<DampedFlight> auto& x) {
    visit("body", x.body);
    visit("position", x.position);
    visit("velocity", x.velocity);
    visit("acceleration", x.acceleration);
    visit("damping", x.damping);
}
void fields(auto& visit, OrConst<PendulumMotion> auto& x) {
    visit("body", x.body);
    visit("pivot", x.pivot);
    visit("length", x.length);
    visit("equivalentLength", x.equivalentLength);
    visit("gravity", x.gravity);
    visit("amplitude", x.amplitude);
    visit("bodyAngle", x.bodyAngle);
    visit("turns", x.turns);
    visit("from", x.from);
    visit("approach", x.approach);
    visit("side", x.side);
}
void fields(auto& visit, OrConst<OscillatorMotion> auto& x) {
    visit("body", x.body);
    visit("rest", x.rest);
    visit("direction", x.direction);
    visit("offset", x.offset);
    visit("speed", x.speed);
    visit("mass", x.mass);
    visit("stiffness", x.stiffness);
    visit("damping", x.damping);
}
void fields(auto& visit, OrConst<DragFall> auto& x) {
    visit("body", x.body);
    visit("position", x.position);
    visit("terminalSpeed", x.terminalSpeed);
    visit("gravity", x.gravity);
}
void fields(auto& visit, OrConst<KeplerMotion> auto& x) {
    visit("body", x.body);
    visit("focus", x.focus);
    visit("drift", x.drift);
    visit("nearEnd", x.nearEnd);
    visit("semiMajorAxis", x.semiMajorAxis);
    visit("eccentricity", x.eccentricity);
    visit("period", x.period);
    visit("since", x.since);
}
void fields(auto& visit, OrConst<BodyMotion> auto& x) {
    visit.oneOf(x, motionTags);
}
void fields(auto& visit, OrConst<ClosedForm> auto& x) {
    visit("formula", x.formula);
    visit("source", x.source);
    visit("until", x.until);
    visit("bodies", x.bodies);
}
void fields(auto& visit, OrConst<AngleProbe> auto& x) {
    visit("body", x.body);
}
void fields(auto& visit, OrConst<NormalForceProbe> auto& x) {
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
}
void fields(auto& visit, OrConst<JointForceProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, OrConst<PositionProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
}
void fields(auto& visit, OrConst<VelocityProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
}
void fields(auto& visit, OrConst<LimitProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, OrConst<JointBrokenProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, OrConst<SensorCountProbe> auto& x) {
    visit("body", x.body);
}
void fields(auto& visit, OrConst<SnagsProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
    visit("drop", x.drop);
}
void fields(auto& visit, OrConst<ApartProbe> auto& x) {
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
    visit("direction", x.direction);
}
void fields(auto& visit, OrConst<Probe> auto& x) {
    visit("name", x.name);
    visit.oneOf(x.quantity, probeTags);
    visit("expected", x.expected);
    visit("from", x.from);
    visit("until", x.until);
    visit("watch", x.watch);
    visit("unit", x.unit);
}
void fields(auto& visit, OrConst<ExactCheck> auto& x) {
    visit("limit", x.limit);
    visit("reason", x.reason);
}
void fields(auto& visit, OrConst<AgreeCheck> auto& x) {
    visit("tolerance", x.tolerance);
    visit("until", x.until);
    visit("reason", x.reason);
}
void fields(auto& visit, OrConst<InvariantCheck> auto& x) {
    visit("metric", x.metric);
    visit("limit", x.limit);
    visit("engines", x.engines);
    visit("reason", x.reason);
}
void fields(auto& visit, OrConst<OrderCheck> auto& x) {
    visit("order", x.order);
    visit("engines", x.engines);
    visit("reason", x.reason);
}
void fields(auto& visit, OrConst<Check> auto& x) {
    visit.oneOf(x, checkTags);
}
void fields(auto& visit, OrConst<Scene> auto& x) {
    visit("name", x.name);
    visit("question", x.question);
    visit("gravity", x.gravity);
    visit("duration", x.duration);
    visit("dt", x.dt);
    visit("sleeping", x.sleeping);
    visit("bodies", x.bodies);
    visit("joints", x.joints);
    visit("fields", x.fields);
    visit("movers", x.movers);
    visit("wrap", x.wrap);
    visit("closedForm", x.closedForm);
    visit("probes", x.probes);
    visit("checks", x.checks);
}

}  // namespace plumb::compare
