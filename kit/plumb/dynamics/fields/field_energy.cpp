// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_energy.h>

#include <cmath>

#include <plumb/dynamics/fields/field_scope.h>
#include <plumb/dynamics/fields/submerged_parts.h>
#include <plumb/forces/gravity.h>

namespace plumb {

namespace {

/// Two bodies at the same place, or too near for a finite number, have no force on each other, and so no energy.
double finite(double energy) {
    return std::isfinite(energy) ? energy : 0;
}

double mutualEnergy(const FieldStores& view, const FieldRecord& field, const MutualGravity& law) {
    double sum = 0;
    const std::vector<BodyMotion>& now = view.bodies.motion;
    const auto massOf = [&](BodyIndex body) { return PointMass{view.bodies.record[body].mass, now[body].center}; };
    for (BodyIndex a = 1; a < now.size(); ++a) {
        if (!actsOn(field, view, a, now[a])) continue;
        for (BodyIndex b = a + 1; b < now.size(); ++b)
            if (actsOn(field, view, b, now[b])) {
                PointMass other = massOf(b);
                other.position = view.bodies.near(other.position, now[a].center);
                sum += finite(potentialEnergy(law, massOf(a), other));
            }
    }
    return sum;
}

double mutualEnergy(const FieldStores& view, const FieldRecord& field, const MutualGravity& law, BodyIndex body,
                    const BodyMotion& there) {
    double sum = 0;
    const std::vector<BodyMotion>& now = view.bodies.motion;
    const PointMass self{view.bodies.record[body].mass, there.center};
    for (BodyIndex other = 1; other < now.size(); ++other)
        if (other != body && actsOn(field, view, other, now[other]))
            sum += finite(potentialEnergy(
                law, {view.bodies.record[other].mass, view.bodies.near(now[other].center, there.center)}, self));
    return sum;
}

/// The energy of one body in a field that acts on each body independently of the others.
double energyIn(const FieldStores& view, const FieldRecord& field, BodyIndex body, BodyMotion motion) {
    const FieldLaw& law = field.def.law;
    motion.center += shiftInto(field, view, motion.center).value_or(Vec2(0, 0));
    if (const auto* uniform = std::get_if<UniformGravity>(&law))
        return potentialEnergy(*uniform, view.bodies.record[body].mass, motion.center);
    if (const auto* attractor = std::get_if<Attractor>(&law)) return finite(potentialEnergy(*attractor, motion.center));
    if (const auto* magnet = std::get_if<Magnet>(&law)) {
        Attractor attractor = attractorOf(*magnet, view, view.bodies.motion);
        attractor.center = view.bodies.near(attractor.center, motion.center);
        return finite(potentialEnergy(attractor, motion.center));
    }
    double sum = 0;
    if (const auto* pool = std::get_if<Pool>(&law))
        for (const Submerged& part : submergedPartsOf(view.bodies, view.space, body, motion, pool->fluid))
            sum += potentialEnergy(pool->fluid, part);
    return sum;
}

}  // namespace

bool hasEnergy(const FieldDef& field) {
    return !field.region && !std::holds_alternative<Drag>(field.law) &&
           !std::holds_alternative<GroundFriction>(field.law);
}

double fieldEnergyOf(const FieldStores& view) {
    double sum = 0;
    for (const FieldRecord& field : view.fields.records) {
        if (!field.alive || !hasEnergy(field.def)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(view, field, *mutual);
        else
            for (const BodyIndex body : bodiesInfluencedBy(view, field))
                sum += energyIn(view, field, body, view.bodies.motion[body]);
    }
    return sum;
}

double fieldEnergyOf(const FieldStores& view, BodyIndex body, const BodyMotion& there) {
    double sum = 0;
    for (const FieldRecord& field : view.fields.records) {
        if (!field.alive || !hasEnergy(field.def) || !actsOn(field, view, body, there)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(view, field, *mutual, body, there);
        else if (!isCarriedBy(field.def.law, body))
            sum += energyIn(view, field, body, there);
    }
    return sum;
}

}  // namespace plumb
