// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <compare/scene/answer.h>
#include <compare/scene/fields.h>
#include <compare/scene/name_index.h>
#include <compare/scene/named.h>
#include <compare/scene/require_fields.h>
#include <compare/scene/scene.h>
#include <compare/scene/validate/parts.h>
#include <plumb/math/check.h>

namespace plumb::compare {
namespace {

constexpr double maxSteps = 1e7;  // a day and a half at 60 Hz; a state of each step is kept

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

/// The scene's name is also used as the name of a file.
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
        requireFields(flight, path);
        if (i == 0 && flight.start > 0)
            refuse(path + ".start", toText(flight.start) + " is not 0: the first flight starts with the scene");
        if (i > 0 && flight.start < motion.flights[i - 1].start) {
            refuse(path + ".start", toText(flight.start) + " is before the flight before it");
        }
    }
}

void requireUnit(const Vec2& direction, const std::string& field) {
    constexpr double rounding = 1e-9;
    if (std::abs(direction.norm() - 1) > rounding) refuse(field, toText(direction) + " is not of length 1");
}

void validateMotion(const DampedFlight& motion, const std::string& field) {
    requireFields(motion, field + ".damped");
}

void validateMotion(const PendulumMotion& motion, const std::string& field) {
    const std::string path = field + ".pendulum";
    requireFields(motion, path);
    if (!(std::abs(motion.amplitude) < std::numbers::pi)) {
        refuse(path + ".amplitude", toText(motion.amplitude) + " is not between -pi and pi");
    }
}

void validateMotion(const OscillatorMotion& motion, const std::string& field) {
    requireFields(motion, field + ".oscillator");
    requireUnit(motion.direction, field + ".oscillator.direction");
}

void validateMotion(const DragFall& motion, const std::string& field) {
    requireFields(motion, field + ".dragFall");
}

void validateMotion(const KeplerMotion& motion, const std::string& field) {
    requireFields(motion, field + ".kepler");
    requireUnit(motion.nearEnd, field + ".kepler.nearEnd");
}

/// Validates a motion that holds names.
void validateNamed(const auto& motion, const Scene& scene, const std::string& path) {
    requireFields(motion, path);
    if constexpr (requires { motion.joint; })
        requireKnown(motion.joint, namesOf(scene.joints), path + ".joint", "a joint");
    if constexpr (requires { motion.field; })
        requireKnown(motion.field, namesOf(scene.fields), path + ".field", "a field");
    if constexpr (requires { motion.after; })
        if (!motion.after.empty()) requireKnown(motion.after, namesOf(scene.bodies), path + ".after", "a body");
    if constexpr (requires { motion.bullet; }) {
        requireKnown(motion.bullet, namesOf(scene.bodies), path + ".bullet", "a body");
        requireKnown(motion.block, namesOf(scene.bodies), path + ".block", "a body");
        if (motion.body != motion.bullet && motion.body != motion.block)
            refuse(path + ".body", quoted(motion.body) + " is neither bullet nor block, wanted one of them");
    }
}

/// Uses the kit's check, and puts the path before its message.
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

void validateClosedForm(const ClosedForm& form, const Scene& scene) {
    const std::vector<std::string> bodies = namesOf(scene.bodies);
    requireFields(form, "closedForm");
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
        const auto check = [&](const auto& motion) {
            if constexpr (requires { validateMotion(motion, field); })
                validateMotion(motion, field);
            else
                validateNamed(motion, scene, field + "." + motionTags[form.bodies[i].index()]);
        };
        std::visit(check, form.bodies[i]);
    }
}

void validateProbe(const Probe& probe, const Scene& scene, const std::string& field) {
    const std::vector<std::string> bodies = namesOf(scene.bodies);
    const std::string path = field + "." + probeTags[probe.quantity.index()];
    const auto check = [&](const auto& quantity) {
        if constexpr (requires { quantity.body; }) requireKnown(quantity.body, bodies, path + ".body", "a body");
        requireFields(quantity, path);
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
    requireFields(probe, field);
    if (probe.until > 0 && probe.until < probe.from)
        refuse(field + ".until", toText(probe.until) + " is before from, " + toText(probe.from));
}

void validateCheck(const Check& check, const Scene& scene, const std::string& field) {
    const std::string path = field + "." + checkTags[check.index()];
    std::visit([&](const auto& one) { requireFields(one, path); }, check);
    if (std::holds_alternative<ExactCheck>(check) && !scene.closedForm)
        refuse(path, "the scene has no closed form to be exact to");
    if (std::holds_alternative<OrderCheck>(check) && !scene.closedForm)
        refuse(path, "the scene has no closed form to tell errors by");
    if (const auto* invariant = std::get_if<InvariantCheck>(&check)) {
        requireKnown(invariant->metric, checkableMetrics(scene), path + ".metric", "a metric of this scene");
    }
}

void validateControl(const SceneControl& control, const std::string& field) {
    requireFields(control, field);
    if (control.from >= control.to)
        refuse(field + ".to", toText(control.to) + " is not above from, " + toText(control.from));
}

}  // namespace

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
    if (scene.closedForm) validateClosedForm(*scene.closedForm, scene);
    (void)answerParts(scene);
    for (std::size_t i = 0; i < scene.checks.size(); ++i) validateCheck(scene.checks[i], scene, at("checks", i));
    for (std::size_t i = 0; i < scene.controls.size(); ++i) validateControl(scene.controls[i], at("controls", i));
}

}  // namespace plumb::compare
