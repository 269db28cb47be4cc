// SPDX-License-Identifier: MIT
// Which fields has each part of a scene, and what are they called in a file?
// One list a type, for reader and writer alike, so that they cannot differ. A visitor offers
//   visit("name", field)                a field,
//   visit.orInfinite("name", field)     a number that may be infinite, of either sign,
//   visit.shape(shape)                  a shape under its kind: "circle": {...},
//   visit.oneOf(variant, {tags...})     one alternative of a variant under its tag.
#pragma once
#include <array>
#include <concepts>
#include <initializer_list>
#include <span>
#include <type_traits>

#include <compare/scene/scene.h>
#include <plumb/shapes/tile_text.h>

namespace plumb::compare {

// What the enumerators are called in a file, in their order.
inline constexpr std::array<const char*, 3> bodyTypeTags{"static", "kinematic", "dynamic"};
inline constexpr std::array<const char*, 5> mixTags{"average", "geometricMean", "minimum", "product", "maximum"};
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
constexpr std::span<const char* const> tagsOf(BodyType) {
    return bodyTypeTags;
}
constexpr std::span<const char* const> tagsOf(Mix) {
    return mixTags;
}
constexpr std::span<const char* const> tagsOf(Side) {
    return sideTags;
}
constexpr std::span<const char* const> tagsOf(Watch) {
    return watchTags;
}

inline constexpr std::initializer_list<const char*> shapeTags{"circle",  "capsule", "polygon",
                                                              "segment", "chain",   "tiles"};  ///< as in Shape

inline constexpr std::initializer_list<const char*> jointTags{"revolute", "prismatic", "distance", "weld",   "wheel",
                                                              "pulley",   "gear",      "motor",    "target", "filter"};
inline constexpr std::initializer_list<const char*> motionTags{"piecewise",  "damped",   "pendulum",
                                                               "oscillator", "dragFall", "kepler"};
inline constexpr std::initializer_list<const char*> moverTags{"path", "slide", "grid", "platform"};
inline constexpr std::initializer_list<const char*> lawTags{
    "uniformGravity", "mutualGravity", "drag", "attractor", "magnet", "pool", "groundFriction"};
inline constexpr std::initializer_list<const char*> probeTags{"angle",    "normalForce", "jointForce",  "position",
                                                              "velocity", "limit",       "jointBroken", "sensorCount",
                                                              "snags",    "apart"};

// Of a number without bound, for which JSON has no sign.
inline constexpr const char* infiniteTag = "infinite";
inline constexpr const char* minusInfiniteTag = "-infinite";

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

void fields(auto& visit, Is<Circle> auto& x) {
    visit("radius", x.radius);
    visit("center", x.center);
}
void fields(auto& visit, Is<Capsule> auto& x) {
    visit("start", x.start);
    visit("end", x.end);
    visit("radius", x.radius);
}
void fields(auto& visit, Is<Polygon> auto& x) {
    visit("vertices", x.vertices);
    visit("radius", x.radius);
}
void fields(auto& visit, Is<Segment> auto& x) {
    visit("start", x.start);
    visit("end", x.end);
    visit("before", x.before);
    visit("after", x.after);
}
void fields(auto& visit, Is<Chain> auto& x) {
    visit("points", x.points);
    visit("closed", x.closed);
}
/// A box as a file may give it; it is kept as the polygon it is.
struct BoxFields {
    Vec2 halfSize{0.5, 0.5};  ///< [m]
    Vec2 center{0, 0};        ///< [m]
    double radius = 0;        ///< the outline lies so far outside of the box [m]
};
void fields(auto& visit, Is<BoxFields> auto& x) {
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
void fields(auto& visit, Is<TilesFields> auto& x) {
    visit("rows", x.rows);
    visit("size", x.size);
    visit("wrapX", x.wrapX);
    visit("wrapY", x.wrapY);
}
void fields(auto& visit, Is<Material> auto& x) {
    visit("density", x.density);
    visit("friction", x.friction);
    visit("restitution", x.restitution);
    visit("rollingResistance", x.rollingResistance);
    visit("surfaceSpeed", x.surfaceSpeed);
    visit("frictionMix", x.frictionMix);
    visit("restitutionMix", x.restitutionMix);
}
void fields(auto& visit, Is<Filter> auto& x) {
    visit("category", x.category);
    visit("mask", x.mask);
    visit("group", x.group);
}
void fields(auto& visit, Is<ShapeDef> auto& x) {
    visit.shape(x.shape);
    visit("material", x.material);
    visit("filter", x.filter);
    visit("sensor", x.sensor);
    visit("oneWay", x.oneWay);
    visit("tag", x.tag);
}
void fields(auto& visit, Is<Mass> auto& x) {
    visit("mass", x.mass);
    visit("center", x.center);
    visit("inertia", x.inertia);
}
void fields(auto& visit, Is<BodyDef> auto& x) {
    visit("type", x.type);
    visit("position", x.position);
    visit("angle", x.angle);
    visit("velocity", x.velocity);
    visit("angularVelocity", x.angularVelocity);
    visit("gravityScale", x.gravityScale);
    visit("linearDamping", x.linearDamping);
    visit("angularDamping", x.angularDamping);
    visit("fixedRotation", x.fixedRotation);
    visit("lockX", x.lockX);
    visit("lockY", x.lockY);
    visit("canSleep", x.canSleep);
    visit("awake", x.awake);
    visit("enabled", x.enabled);
    visit("tag", x.tag);
    visit("mass", x.mass);
    visit("shapes", x.shapes);
}
void fields(auto& visit, Is<SceneBody> auto& x) {
    visit("name", x.name);
    fields(visit, x.def);
}
void fields(auto& visit, Is<Spring> auto& x) {
    visit("stiffness", x.stiffness);
    visit("damping", x.damping);
}
void fields(auto& visit, Is<Limit> auto& x) {
    visit.orInfinite("lower", x.lower);
    visit.orInfinite("upper", x.upper);
}
void fields(auto& visit, Is<Breaking> auto& x) {
    visit.orInfinite("force", x.force);
    visit.orInfinite("torque", x.torque);
}
void fields(auto& visit, Is<RevoluteJointDef> auto& x) {
    visit("anchor", x.anchor);
    visit("motorSpeed", x.motorSpeed);
    visit.orInfinite("maxMotorTorque", x.maxMotorTorque);
    visit("limit", x.limit);
    visit("spring", x.spring);
    visit("restAngle", x.restAngle);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<PrismaticJointDef> auto& x) {
    visit("anchor", x.anchor);
    visit("axis", x.axis);
    visit("motorSpeed", x.motorSpeed);
    visit.orInfinite("maxMotorForce", x.maxMotorForce);
    visit("limit", x.limit);
    visit("spring", x.spring);
    visit("restShift", x.restShift);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<DistanceJointDef> auto& x) {
    visit("anchorA", x.anchorA);
    visit("anchorB", x.anchorB);
    visit("length", x.length);
    visit("spring", x.spring);
    visit("minLength", x.minLength);
    visit.orInfinite("maxLength", x.maxLength);
    visit("motorSpeed", x.motorSpeed);
    visit.orInfinite("maxMotorForce", x.maxMotorForce);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<WeldJointDef> auto& x) {
    visit("anchor", x.anchor);
    visit("spring", x.spring);
    visit("bending", x.bending);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<WheelJointDef> auto& x) {
    visit("anchor", x.anchor);
    visit("axis", x.axis);
    visit("motorSpeed", x.motorSpeed);
    visit.orInfinite("maxMotorTorque", x.maxMotorTorque);
    visit("limit", x.limit);
    visit("spring", x.spring);
    visit("restShift", x.restShift);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<PulleyJointDef> auto& x) {
    visit("groundA", x.groundA);
    visit("groundB", x.groundB);
    visit("anchorA", x.anchorA);
    visit("anchorB", x.anchorB);
    visit("ratio", x.ratio);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<GearJointDef> auto& x) {
    visit("ratio", x.ratio);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<MotorJointDef> auto& x) {
    visit("offset", x.offset);
    visit("angle", x.angle);
    visit("rate", x.rate);
    visit("velocity", x.velocity);
    visit("angularVelocity", x.angularVelocity);
    visit.orInfinite("maxForce", x.maxForce);
    visit.orInfinite("maxTorque", x.maxTorque);
    visit("collideConnected", x.collideConnected);
    visit("breaking", x.breaking);
}
void fields(auto& visit, Is<TargetJointDef> auto& x) {
    visit("anchor", x.anchor);
    visit("target", x.target);
    visit("spring", x.spring);
    visit.orInfinite("maxForce", x.maxForce);
    visit("breaking", x.breaking);
}
void fields(auto&, Is<FilterJointDef> auto&) {}
void fields(auto& visit, Is<SceneJoint> auto& x) {
    visit("name", x.name);
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
    visit("jointA", x.jointA);
    visit("jointB", x.jointB);
    visit.oneOf(x.def, jointTags);
}
void fields(auto& visit, Is<UniformGravity> auto& x) {
    visit("acceleration", x.acceleration);
}
void fields(auto& visit, Is<MutualGravity> auto& x) {
    visit("constant", x.constant);
    visit("softening", x.softening);
}
void fields(auto& visit, Is<Drag> auto& x) {
    visit("linear", x.linear);
    visit("quadratic", x.quadratic);
    visit("wind", x.wind);
}
void fields(auto& visit, Is<Attractor> auto& x) {
    visit("center", x.center);
    visit("strength", x.strength);
    visit("power", x.power);
    visit("softening", x.softening);
    visit.orInfinite("range", x.range);
}
void fields(auto& visit, Is<Magnet> auto& x) {
    fields(visit, x.pull);
}
void fields(auto& visit, Is<Fluid> auto& x) {
    visit("density", x.density);
    visit("surface", x.surface);
    visit("gravity", x.gravity);
}
void fields(auto& visit, Is<Pool> auto& x) {
    visit("fluid", x.fluid);
    visit("drag", x.drag);
    visit("flow", x.flow);
}
void fields(auto& visit, Is<GroundFriction> auto& x) {
    visit("friction", x.friction);
    visit("gravity", x.gravity);
    visit("lever", x.lever);
}
void fields(auto& visit, Is<Shape> auto& x) {
    visit.shape(x);
}
void fields(auto& visit, Is<SceneField> auto& x) {
    visit("name", x.name);
    visit("body", x.body);
    visit.oneOf(x.def.law, lawTags);
    visit("region", x.def.region);
    visit("filter", x.def.filter);
}
void fields(auto& visit, Is<Wrap> auto& x) {
    visit("width", x.width);
    visit("height", x.height);
}
void fields(auto& visit, Is<Cell> auto& x) {
    visit("column", x.column);
    visit("row", x.row);
}
void fields(auto& visit, Is<PathMotion> auto& x) {
    visit("points", x.points);
    visit("spline", x.spline);
    visit("closed", x.closed);
    visit("delay", x.delay);
    visit("speed", x.speed);
    visit("acceleration", x.acceleration);
    visit("easing", x.easing);
    visit("repeat", x.repeat);
}
void fields(auto& visit, Is<SlidingMotion> auto& x) {
    visit("velocity", x.velocity);
    visit("pushStrength", x.pushStrength);
    visit("standIn", x.standIn);
}
void fields(auto& visit, Is<GridMotion> auto& x) {
    visit("map", x.map);
    visit("cell", x.cell);
    visit("heading", x.heading);
    visit("speed", x.speed);
    visit("turns", x.turns);
}
void fields(auto& visit, Is<PlatformCue> auto& x) {
    visit("time", x.time);
    visit("move", x.move);
    visit("run", x.run);
    visit("jump", x.jump);
}
void fields(auto& visit, Is<PlatformMotion> auto& x) {
    visit("profile", x.profile);
    visit("cues", x.cues);
}
void fields(auto& visit, Is<SceneMover> auto& x) {
    visit("name", x.name);
    visit("body", x.body);
    visit.oneOf(x.motion, moverTags);
}
void fields(auto& visit, Is<Flight> auto& x) {
    visit("start", x.start);
    visit("position", x.position);
    visit("velocity", x.velocity);
    visit("acceleration", x.acceleration);
    visit("angle", x.angle);
    visit("angularVelocity", x.angularVelocity);
    visit("angularAcceleration", x.angularAcceleration);
}
void fields(auto& visit, Is<PiecewiseMotion> auto& x) {
    visit("body", x.body);
    visit("flights", x.flights);
}
void fields(auto& visit, Is<DampedFlight> auto& x) {
    visit("body", x.body);
    visit("position", x.position);
    visit("velocity", x.velocity);
    visit("acceleration", x.acceleration);
    visit("damping", x.damping);
}
void fields(auto& visit, Is<PendulumMotion> auto& x) {
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
void fields(auto& visit, Is<OscillatorMotion> auto& x) {
    visit("body", x.body);
    visit("rest", x.rest);
    visit("direction", x.direction);
    visit("offset", x.offset);
    visit("speed", x.speed);
    visit("mass", x.mass);
    visit("stiffness", x.stiffness);
    visit("damping", x.damping);
}
void fields(auto& visit, Is<DragFall> auto& x) {
    visit("body", x.body);
    visit("position", x.position);
    visit("terminalSpeed", x.terminalSpeed);
    visit("gravity", x.gravity);
}
void fields(auto& visit, Is<KeplerMotion> auto& x) {
    visit("body", x.body);
    visit("focus", x.focus);
    visit("drift", x.drift);
    visit("nearEnd", x.nearEnd);
    visit("semiMajorAxis", x.semiMajorAxis);
    visit("eccentricity", x.eccentricity);
    visit("period", x.period);
    visit("since", x.since);
}
void fields(auto& visit, Is<BodyMotion> auto& x) {
    visit.oneOf(x, motionTags);
}
void fields(auto& visit, Is<ClosedForm> auto& x) {
    visit("formula", x.formula);
    visit("source", x.source);
    visit("until", x.until);
    visit("bodies", x.bodies);
}
void fields(auto& visit, Is<AngleProbe> auto& x) {
    visit("body", x.body);
}
void fields(auto& visit, Is<NormalForceProbe> auto& x) {
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
}
void fields(auto& visit, Is<JointForceProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, Is<PositionProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
}
void fields(auto& visit, Is<VelocityProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
}
void fields(auto& visit, Is<LimitProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, Is<JointBrokenProbe> auto& x) {
    visit("joint", x.joint);
}
void fields(auto& visit, Is<SensorCountProbe> auto& x) {
    visit("body", x.body);
}
void fields(auto& visit, Is<SnagsProbe> auto& x) {
    visit("body", x.body);
    visit("direction", x.direction);
    visit("drop", x.drop);
}
void fields(auto& visit, Is<ApartProbe> auto& x) {
    visit("bodyA", x.bodyA);
    visit("bodyB", x.bodyB);
    visit("direction", x.direction);
}
void fields(auto& visit, Is<Probe> auto& x) {
    visit("name", x.name);
    visit.oneOf(x.quantity, probeTags);
    visit("expected", x.expected);
    visit("from", x.from);
    visit("until", x.until);
    visit("watch", x.watch);
    visit("unit", x.unit);
}
void fields(auto& visit, Is<ExactCheck> auto& x) {
    visit("limit", x.limit);
    visit("reason", x.reason);
}
void fields(auto& visit, Is<AgreeCheck> auto& x) {
    visit("tolerance", x.tolerance);
    visit("until", x.until);
    visit("reason", x.reason);
}
void fields(auto& visit, Is<InvariantCheck> auto& x) {
    visit("metric", x.metric);
    visit("limit", x.limit);
    visit("engines", x.engines);
    visit("reason", x.reason);
}
void fields(auto& visit, Is<OrderCheck> auto& x) {
    visit("order", x.order);
    visit("engines", x.engines);
    visit("reason", x.reason);
}
void fields(auto& visit, Is<Check> auto& x) {
    visit.oneOf(x, {"exact", "agree", "invariant", "order"});
}
void fields(auto& visit, Is<Scene> auto& x) {
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
