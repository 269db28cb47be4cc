// SPDX-License-Identifier: MIT
#include <compare/field/scene_fields.h>

#include <algorithm>
#include <cmath>

#include <compare/scene/joint_geometry.h>
#include <compare/scene/shape_pair.h>
#include <plumb/collide/distance.h>
#include <plumb/math/transform.h>

namespace plumb::compare {
namespace {

struct Corners {
    std::vector<Vec2> points;
    double radius = 0;
};

/// The corners of a shape with an area; a line has none.
Corners cornersOf(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return {{circle->center}, circle->radius};
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return {{capsule->start, capsule->end}, capsule->radius};
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return {polygon->vertices, polygon->radius};
    return {};
}

/// The parts of a body that are under water.
std::vector<Submerged> submergedParts(const BodyDef& def, const BodyState& state, const Fluid& fluid) {
    std::vector<Submerged> parts;
    const Transform pose{state.position, Rot::fromAngle(state.angle)};
    for (const ShapeDef& shape : def.shapes) {
        Corners corners = cornersOf(shape.shape);
        if (shape.sensor || corners.points.empty()) continue;
        for (Vec2& corner : corners.points) corner = pose * corner;
        parts.push_back(submergedPart(corners.points, corners.radius, fluid));
    }
    return parts;
}

}  // namespace

SceneFields::SceneFields(const Scene& scene) {
    for (const SceneField& field : scene.fields) {
        const bool carried = std::holds_alternative<Magnet>(field.def.law);
        fields_.push_back({field.def, carried ? bodyIndex(scene, field.body) : 0});
    }
    if (fields_.empty()) return;
    for (const SceneBody& body : scene.bodies) {
        defs_.push_back(body.def);
        masses_.push_back(massOf(body.def));
    }
}

std::vector<SceneFields::Body> SceneFields::placed(std::span<const BodyState> states) const {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < defs_.size(); ++i) {
        const Transform pose{states[i].position, Rot::fromAngle(states[i].angle)};
        bodies.push_back({defs_[i].type == BodyType::Dynamic && defs_[i].enabled, &defs_[i], masses_[i],
                          pose * masses_[i].center, &states[i]});
    }
    return bodies;
}

bool SceneFields::actsOn(const Field& field, const Body& body) {
    if (!body.dynamic) return false;
    const bool all = field.def.filter == Filter{};
    const auto met = [&](const ShapeDef& shape) { return accepts(shape.filter, field.def.filter); };
    if (!all && std::ranges::none_of(body.def->shapes, met)) return false;
    return !field.def.region || distance(Circle{1e-9, body.center}, {}, *field.def.region, {}).separation <= 1e-9;
}

/// What one field does to all bodies.
class FieldWork {
public:
    using Body = SceneFields::Body;
    using Field = SceneFields::Field;

    FieldWork(const Field& field, const std::vector<Body>& bodies, double dt, std::vector<FieldForce>& forces)
        : field_(field), bodies_(bodies), dt_(dt), forces_(forces) {}

    void operator()(const UniformGravity& law) {
        forEach([&](std::size_t i) { push(i, gravityForce(law, bodies_[i].mass.mass)); });
    }
    void operator()(const MutualGravity& law) {
        forEach([&](std::size_t a) {
            for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
                if (!SceneFields::actsOn(field_, bodies_[b])) continue;
                const Vec2 onB = gravityForce(law, pointOf(a), pointOf(b));
                push(b, onB);
                push(a, -onB);
            }
        });
    }
    void operator()(const Drag& law) {
        forEach([&](std::size_t i) { push(i, dragForce(law, bodies_[i].state->velocity)); });
    }
    void operator()(const Attractor& law) {
        forEach([&](std::size_t i) { push(i, attraction(law, bodies_[i].center)); });
    }
    void operator()(const Magnet& law) {
        const Attractor pull = placedAt(law);
        forEach([&](std::size_t i) {
            if (i == field_.carrier) return;
            const Vec2 force = attraction(pull, bodies_[i].center);
            push(i, force);
            if (bodies_[field_.carrier].dynamic) push(field_.carrier, -force, pull.center);
        });
    }
    void operator()(const Pool& law) {
        forEach([&](std::size_t i) {
            for (const Submerged& part : submergedParts(*bodies_[i].def, *bodies_[i].state, law.fluid)) {
                push(i, buoyancyForce(law.fluid, part), part.centroid);
                push(i, law.drag * part.area * Vec2(law.flow - bodies_[i].state->velocity));
                const Mass& mass = bodies_[i].mass;
                forces_[i].torque -=
                    law.drag * part.area * mass.inertia / mass.mass * bodies_[i].state->angularVelocity;
            }
        });
    }
    void operator()(const GroundFriction& law) {
        forEach([&](std::size_t i) {
            const Mass& mass = bodies_[i].mass;
            GroundFriction ground = law;
            if (law.lever == 0) ground.lever = 2.0 / 3 * std::sqrt(2 * mass.inertia / mass.mass);
            const Vec2 v = bodies_[i].state->velocity;
            push(i, mass.mass * Vec2(velocityAfterFriction(ground, v, dt_) - v) / dt_);
            const double w = bodies_[i].state->angularVelocity;
            const double after = angularVelocityAfterFriction(ground, mass.mass, mass.inertia, w, dt_);
            forces_[i].torque += mass.inertia * (after - w) / dt_;
        });
    }

    double energyOf(const UniformGravity& law) {
        return sum([&](std::size_t i) { return potentialEnergy(law, bodies_[i].mass.mass, bodies_[i].center); });
    }
    double energyOf(const MutualGravity& law) {
        return sum([&](std::size_t a) {
            double energy = 0;
            for (std::size_t b = a + 1; b < bodies_.size(); ++b)
                if (SceneFields::actsOn(field_, bodies_[b])) energy += potentialEnergy(law, pointOf(a), pointOf(b));
            return energy;
        });
    }
    double energyOf(const Attractor& law) {
        return sum([&](std::size_t i) { return potentialEnergy(law, bodies_[i].center); });
    }
    double energyOf(const Magnet& law) {
        const Attractor pull = placedAt(law);
        return sum([&](std::size_t i) { return i == field_.carrier ? 0 : potentialEnergy(pull, bodies_[i].center); });
    }
    double energyOf(const Pool& law) {
        return sum([&](std::size_t i) {
            double energy = 0;
            for (const Submerged& part : submergedParts(*bodies_[i].def, *bodies_[i].state, law.fluid))
                energy += potentialEnergy(law.fluid, part);
            return energy;
        });
    }
    static double energyOf(const Drag&) { return 0; }
    static double energyOf(const GroundFriction&) { return 0; }

private:
    template <class Work>
    void forEach(Work&& work) {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (SceneFields::actsOn(field_, bodies_[i])) work(i);
    }
    template <class Energy>
    double sum(Energy&& energy) {
        double total = 0;
        forEach([&](std::size_t i) { total += energy(i); });
        return total;
    }
    void push(std::size_t body, const Vec2& force) { push(body, force, bodies_[body].center); }
    void push(std::size_t body, const Vec2& force, const Vec2& at) {
        forces_[body].force += force;
        forces_[body].torque += cross(Vec2(at - bodies_[body].center), force);
    }
    PointMass pointOf(std::size_t body) const { return {bodies_[body].mass.mass, bodies_[body].center}; }
    Attractor placedAt(const Magnet& law) const {
        const BodyState& carrier = *bodies_[field_.carrier].state;
        Attractor pull = law.pull;
        pull.center = Transform{carrier.position, Rot::fromAngle(carrier.angle)} * law.pull.center;
        return pull;
    }

    const Field& field_;
    const std::vector<Body>& bodies_;
    double dt_;
    std::vector<FieldForce>& forces_;
};

std::vector<FieldForce> SceneFields::at(std::span<const BodyState> states, double dt) const {
    std::vector<FieldForce> forces(states.size());
    const std::vector<Body> bodies = placed(states);
    for (const Field& field : fields_) std::visit(FieldWork(field, bodies, dt, forces), field.def.law);
    return forces;
}

double SceneFields::energyAt(std::span<const BodyState> states) const {
    std::vector<FieldForce> none;
    const std::vector<Body> bodies = placed(states);
    double sum = 0;
    for (const Field& field : fields_) {
        if (field.def.region) continue;
        FieldWork work(field, bodies, 0, none);
        sum += std::visit([&](const auto& law) { return work.energyOf(law); }, field.def.law);
    }
    return sum;
}

}  // namespace plumb::compare
