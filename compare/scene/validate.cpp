// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <compare/scene/fields.h>
#include <compare/scene/metric_names.h>
#include <compare/scene/name_index.h>
#include <compare/scene/nearest.h>
#include <compare/scene/scene.h>
#include <plumb/math/check.h>

namespace plumb::compare {
namespace {

constexpr double maxSteps = 1e7;  // a day and a half at 60 Hz; a state of each is kept

std::string at(const std::string& list, std::size_t index) {
    return list + "[" + std::to_string(index) + "]";
}

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

/// what: "a body", "an engine".
void requireKnown(const std::string& name, std::span<const std::string> known, const std::string& field,
                  const std::string& what) {
    if (std::ranges::find(known, name) != known.end()) return;
    const std::string hint = known.empty() ? "there is none" : "the nearest is " + nearest(name, known);
    refuse(field, quoted(name) + " is not the name of " + what + ", " + hint);
}

template <class Named>
std::vector<std::string> namesOf(const std::vector<Named>& things) {
    std::vector<std::string> names;
    for (const Named& thing : things) names.push_back(thing.name);
    return names;
}

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
        plumb::validate(shape, at(field + ".shapes", i) + "." + shapeTags.begin()[shape.index()]);
    }
    plumb::validate(body.def, field);
}

void validateJoint(const SceneJoint& joint, const Scene& scene, const NameIndex& bodies, const std::string& field) {
    if (!bodies.find(joint.bodyA)) requireKnown(joint.bodyA, namesOf(scene.bodies), field + ".bodyA", "a body");
    if (!bodies.find(joint.bodyB)) requireKnown(joint.bodyB, namesOf(scene.bodies), field + ".bodyB", "a body");
    if (joint.bodyA == joint.bodyB)
        refuse(field + ".bodyB", quoted(joint.bodyB) + " is bodyA too, wanted another body");
    if (const auto* revolute = std::get_if<RevoluteJointDef>(&joint.def)) {
        requireFinite(revolute->anchor, field, ".revolute.anchor");
        requireFinite(revolute->motorSpeed, field, ".revolute.motorSpeed");
        if (!(revolute->maxMotorTorque >= 0))  // infinite is as much as it takes
            refuse(field + ".revolute.maxMotorTorque", toText(revolute->maxMotorTorque) + " is negative or no number");
    }
    if (const auto* distance = std::get_if<DistanceJointDef>(&joint.def)) {
        requireFinite(distance->anchorA, field, ".distance.anchorA");
        requireFinite(distance->anchorB, field, ".distance.anchorB");
        if (distance->length) requirePositive(*distance->length, field, ".distance.length");
        if (!distance->length && distance->anchorA == distance->anchorB) {
            refuse(field + ".distance.anchorB",
                   toText(distance->anchorB) + " is anchorA too, wanted another point or a length");
        }
    }
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
}

void validateClosedForm(const ClosedForm& form, const std::vector<std::string>& bodies) {
    requireNotNegative(form.until, "closedForm.until");
    if (form.bodies.empty()) refuse("closedForm.bodies", "there is none, wanted at least one");
    constexpr const char* kinds[] = {".piecewise", ".damped", ".pendulum"};  // in the order of BodyMotion
    std::vector<std::string> described;
    for (std::size_t i = 0; i < form.bodies.size(); ++i) {
        const std::string field = at("closedForm.bodies", i);
        const std::string body = std::visit([](const auto& motion) { return motion.body; }, form.bodies[i]);
        const std::string bodyField = field + kinds[form.bodies[i].index()] + ".body";
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
    if (const auto* angle = std::get_if<AngleProbe>(&probe.quantity)) {
        requireKnown(angle->body, bodies, field + ".angle.body", "a body");
    }
    if (const auto* force = std::get_if<NormalForceProbe>(&probe.quantity)) {
        requireKnown(force->bodyA, bodies, field + ".normalForce.bodyA", "a body");
        requireKnown(force->bodyB, bodies, field + ".normalForce.bodyB", "a body");
        if (force->bodyA == force->bodyB) {
            refuse(field + ".normalForce.bodyB", quoted(force->bodyB) + " is bodyA too, wanted another body");
        }
    }
    if (const auto* force = std::get_if<JointForceProbe>(&probe.quantity)) {
        requireKnown(force->joint, namesOf(scene.joints), field + ".jointForce.joint", "a joint");
    }
    requireFinite(probe.expected, field, ".expected");
    requireNotNegative(probe.from, field, ".from");
}

void validateEngines(const std::vector<std::string>& names, const std::string& field) {
    static const std::vector<std::string> known{"plumb", "box2d-2.4", "box2d-3", "closed-form"};
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
    validateNames(scene.probes, "probes");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) validateBody(scene.bodies[i], at("bodies", i));
    const NameIndex index(scene.bodies);
    for (std::size_t i = 0; i < scene.joints.size(); ++i) validateJoint(scene.joints[i], scene, index, at("joints", i));
    for (std::size_t i = 0; i < scene.probes.size(); ++i) validateProbe(scene.probes[i], scene, at("probes", i));
    if (scene.closedForm) validateClosedForm(*scene.closedForm, namesOf(scene.bodies));
    for (std::size_t i = 0; i < scene.checks.size(); ++i) validateCheck(scene.checks[i], scene, at("checks", i));
}

}  // namespace plumb::compare
