// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <compare/scene/fields.h>
#include <compare/scene/metric_names.h>
#include <compare/scene/name_index.h>
#include <compare/scene/named.h>
#include <compare/scene/scene.h>
#include <compare/scene/validate_arrivals.h>
#include <compare/scene/validate_joint.h>
#include <compare/scene/validate_mover.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>

namespace plumb::compare {
namespace {

constexpr double maxSteps = 1e7;  // a day and a half at 60 Hz; a state of each is kept

template <class Named>
void validateNames(const std::vector<Named>& things, const std::string& list) {
    const NameIndex index(things);
    for (std::size_t i = 0; i < things.size(); ++i) {
        const std::string& name = things[i].name;
        if (name.empty()) refuse(at(list, i) + ".name", "\"\" is empty, wanted a name");
        const std::size_t first = index.find(name).value_or(i);
        if (first < i)
            refuse(at(list, i) + ".name",
                   quoted(name) + " is used twice, wanted a name that differs from " + at(list, first));
    }
}

/// The name also becomes a file's.
void validateSceneName(const std::string& name) {
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    if (name.empty() || !std::ranges::all_of(name, fits)) {
        refuse("name", quoted(name) + " is not a name of small letters, digits and underscores");
    }
}

void validateTime(const Scene& scene) {
    requireFinite(scene.gravity, "gravity");
    requireMembers(scene.wrap, {"wrap"});
    requirePositive(scene.duration, "duration");
    requirePositive(scene.dt, "dt");
    const double steps = scene.duration / scene.dt;
    if (steps > maxSteps)
        refuse("dt", toText(scene.dt) + " makes more than 10 million steps of " + toText(scene.duration) + " s");
    if (steps < 0.5)
        refuse("dt", toText(scene.dt) + " is longer than the duration of " + toText(scene.duration) + " s");
}

void validateBody(const SceneBody& body, const std::string& field) {
    for (std::size_t i = 0; i < body.def.shapes.size(); ++i) {
        const Shape& shape = body.def.shapes[i].shape;
        const std::string path = at(field + ".shapes", i);
        plumb::validate(shape, path + "." + tagsOfAlternatives<Shape>[shape.index()]);
        if (body.def.shapes[i].rule != nullptr) refuse(path + ".rule", "is code, and a scene is data: wanted none");
    }
    plumb::validate(body.def, field);
}

void validateMotion(const PiecewiseMotion& motion, const std::string& field) {
    if (motion.flights.empty()) refuse(field + ".piecewise.flights", "there is none, wanted at least one");
    for (std::size_t i = 0; i < motion.flights.size(); ++i) {
        const Flight& flight = motion.flights[i];
        const std::string path = at(field + ".piecewise.flights", i);
        requireFinite(flight.start, path, ".start");
        if (i == 0 && flight.start > 0)
            refuse(path + ".start", toText(flight.start) + " is not 0: the first flight starts with the scene");
        if (i > 0 && flight.start < motion.flights[i - 1].start) {
            refuse(path + ".start", toText(flight.start) + " is before the flight before it");
        }
        requireFinite(flight.position, path, ".position");
        requireFinite(flight.velocity, path, ".velocity");
        requireFinite(flight.acceleration, path, ".acceleration");
        requireFinite(flight.angle, path, ".angle");
        requireFinite(flight.angularVelocity, path, ".angularVelocity");
        requireFinite(flight.angularAcceleration, path, ".angularAcceleration");
    }
}

void validateMotion(const DampedFlight& motion, const std::string& field) {
    requireFinite(motion.position, field, ".damped.position");
    requireFinite(motion.velocity, field, ".damped.velocity");
    requireFinite(motion.acceleration, field, ".damped.acceleration");
    requirePositive(motion.damping, field, ".damped.damping");
}

void validateMotion(const PendulumMotion& motion, const std::string& field) {
    const std::string path = field + ".pendulum";
    requireFinite(motion.pivot, path, ".pivot");
    requirePositive(motion.length, path, ".length");
    requirePositive(motion.equivalentLength, path, ".equivalentLength");
    requirePositive(motion.gravity, path, ".gravity");
    requireFinite(motion.amplitude, path, ".amplitude");
    requireFinite(motion.bodyAngle, path, ".bodyAngle");
    if (!(std::abs(motion.amplitude) < std::numbers::pi)) {
        refuse(path + ".amplitude", toText(motion.amplitude) + " is not between -pi and pi");
    }
    requireNotNegative(motion.from, path, ".from");
    requireFinite(motion.approach, path, ".approach");
}

void requireUnit(const Vec2& direction, const std::string& field) {
    constexpr double rounding = 1e-9;
    requireFinite(direction, field);
    if (std::abs(direction.norm() - 1) > rounding) refuse(field, toText(direction) + " is not of length 1");
}

void validateMotion(const OscillatorMotion& motion, const std::string& field) {
    const std::string path = field + ".oscillator";
    requireFinite(motion.rest, path, ".rest");
    requireUnit(motion.direction, path + ".direction");
    requireFinite(motion.offset, path, ".offset");
    requireFinite(motion.speed, path, ".speed");
    requirePositive(motion.mass, path, ".mass");
    requirePositive(motion.stiffness, path, ".stiffness");
    requireNotNegative(motion.damping, path, ".damping");
}

void validateMotion(const DragFall& motion, const std::string& field) {
    const std::string path = field + ".dragFall";
    requireFinite(motion.position, path, ".position");
    requirePositive(motion.terminalSpeed, path, ".terminalSpeed");
    requirePositive(motion.gravity, path, ".gravity");
}

void validateMotion(const KeplerMotion& motion, const std::string& field) {
    const std::string path = field + ".kepler";
    requireFinite(motion.focus, path, ".focus");
    requireFinite(motion.drift, path, ".drift");
    requireUnit(motion.nearEnd, path + ".nearEnd");
    requirePositive(motion.semiMajorAxis, path, ".semiMajorAxis");
    requireWithin(motion.eccentricity, 0, 1, path, ".eccentricity");
    requirePositive(motion.period, path, ".period");
    requireFinite(motion.since, path, ".since");
}

/// As the kit does it: its message stands after the path.
void validateField(const Scene& scene, std::size_t index) {
    const SceneField& field = scene.fields[index];
    const std::string path = at("fields", index);
    if (std::holds_alternative<Magnet>(field.def.law))
        requireKnown(field.body, namesOf(scene.bodies), path + ".body", "a body");
    else if (!field.body.empty())
        refuse(path + ".body", quoted(field.body) + " carries no magnet: the field is another");
    try {
        plumb::validate(field.def);
    } catch (const std::invalid_argument& error) {
        refuse(path, error.what());
    }
}

void validateClosedForm(const ClosedForm& form, const std::vector<std::string>& bodies) {
    requireNotNegative(form.until, "closedForm.until");
    if (form.bodies.empty()) refuse("closedForm.bodies", "there is none, wanted at least one");
    std::vector<std::string> described;
    for (std::size_t i = 0; i < form.bodies.size(); ++i) {
        const std::string field = at("closedForm.bodies", i);
        const std::string body = std::visit([](const auto& motion) { return motion.body; }, form.bodies[i]);
        const std::string bodyField = field + "." + motionTags[form.bodies[i].index()] + ".body";
        requireKnown(body, bodies, bodyField, "a body");
        if (std::ranges::find(described, body) != described.end()) {
            refuse(bodyField, quoted(body) + " has a motion already, wanted one for each body");
        }
        described.push_back(body);
        std::visit([&](const auto& motion) { validateMotion(motion, field); }, form.bodies[i]);
    }
}

void validateProbe(const Probe& probe, const Scene& scene, const std::string& field) {
    const std::vector<std::string> bodies = namesOf(scene.bodies);
    const std::string path = field + "." + probeTags[probe.quantity.index()];
    const auto check = [&](const auto& quantity) {
        if constexpr (requires { quantity.body; }) requireKnown(quantity.body, bodies, path + ".body", "a body");
        if constexpr (requires { quantity.direction; }) requireUnit(quantity.direction, path + ".direction");
        if constexpr (requires { quantity.bodyA; }) {
            requireKnown(quantity.bodyA, bodies, path + ".bodyA", "a body");
            requireKnown(quantity.bodyB, bodies, path + ".bodyB", "a body");
            if (quantity.bodyA == quantity.bodyB)
                refuse(path + ".bodyB", quoted(quantity.bodyB) + " is bodyA too, wanted another body");
        }
        if constexpr (requires { quantity.joint; })
            requireKnown(quantity.joint, namesOf(scene.joints), path + ".joint", "a joint");
    };
    std::visit(check, probe.quantity);
    if (const auto* snags = std::get_if<SnagsProbe>(&probe.quantity)) requirePositive(snags->drop, path, ".drop");
    requireFinite(probe.expected, field, ".expected");
    requireNotNegative(probe.from, field, ".from");
    requireNotNegative(probe.until, field, ".until");
    if (probe.until > 0 && probe.until < probe.from)
        refuse(field + ".until", toText(probe.until) + " is before from, " + toText(probe.from));
}

void validateEngines(const std::vector<std::string>& names, const std::string& field) {
    static const std::vector<std::string> known{"plumb", "box2d-2.4", "box2d-3", "chipmunk", "closed-form"};
    if (names.empty()) refuse(field, "there is none, wanted at least one");
    for (std::size_t i = 0; i < names.size(); ++i) requireKnown(names[i], known, at(field, i), "an engine");
}

void validateCheck(const Check& check, const Scene& scene, const std::string& field) {
    if (const auto* exact = std::get_if<ExactCheck>(&check)) {
        if (!scene.closedForm) refuse(field + ".exact", "the scene has no closed form to be exact to");
        requireNotNegative(exact->limit, field, ".exact.limit");
    }
    if (const auto* agree = std::get_if<AgreeCheck>(&check)) {
        requirePositive(agree->tolerance, field, ".agree.tolerance");
        requirePositive(agree->until, field, ".agree.until");
    }
    if (const auto* invariant = std::get_if<InvariantCheck>(&check)) {
        requireKnown(invariant->metric, checkableMetrics(scene), field + ".invariant.metric", "a metric of this scene");
        requireNotNegative(invariant->limit, field, ".invariant.limit");
        validateEngines(invariant->engines, field + ".invariant.engines");
    }
    if (const auto* order = std::get_if<OrderCheck>(&check)) {
        if (!scene.closedForm) refuse(field + ".order", "the scene has no closed form to tell errors by");
        requirePositive(order->order, field, ".order.order");
        validateEngines(order->engines, field + ".order.engines");
    }
}

}  // namespace

std::vector<std::string> checkableMetrics(const Scene& scene) {
    std::vector<std::string> names{
        "divergence_max",  "divergence_time", "energy_drift", "momentum_drift", "angular_momentum_drift",
        "penetration_max", "joint_error_max", "settle_time",  "ms_per_step"};
    if (scene.closedForm) names.insert(names.end(), {"error_max", "error_end"});
    for (const Probe& probe : scene.probes) names.push_back("probe." + probe.name);
    return names;
}

void validate(const Scene& scene) {
    validateSceneName(scene.name);
    validateTime(scene);
    if (scene.bodies.empty()) refuse("bodies", "there is none, wanted at least one");
    validateNames(scene.bodies, "bodies");
    validateNames(scene.joints, "joints");
    validateNames(scene.fields, "fields");
    validateNames(scene.movers, "movers");
    validateNames(scene.probes, "probes");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) validateBody(scene.bodies[i], at("bodies", i));
    const NameIndex index(scene.bodies);
    for (std::size_t i = 0; i < scene.joints.size(); ++i) validateJoint(scene, i, index);
    validateArrivals(scene, index);
    for (std::size_t i = 0; i < scene.fields.size(); ++i) validateField(scene, i);
    for (std::size_t i = 0; i < scene.movers.size(); ++i) validateMover(scene, i);
    for (std::size_t i = 0; i < scene.probes.size(); ++i) validateProbe(scene.probes[i], scene, at("probes", i));
    if (scene.closedForm) validateClosedForm(*scene.closedForm, namesOf(scene.bodies));
    for (std::size_t i = 0; i < scene.checks.size(); ++i) validateCheck(scene.checks[i], scene, at("checks", i));
}

}  // namespace plumb::compare
