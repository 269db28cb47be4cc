// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Work = m dv.mean = m (v'^2 - v^2) / 2: exactly the change of kinetic energy by the kick, so the ledger closes to
/// rounding. m mass [kg], dv change, mean = (v + v') / 2 [m/s]. Test: "in rooms with every field the ledger closes, and
/// a copy goes on to the same bits"
void FieldAccount::add(const BodyRecord& body, const FieldKick& kick, const VelocityChange& mean, const Vec2& base) {
    const auto workOf = [&](const VelocityChange& push) {
        const double turned = body.inverseInertia > 0 ? body.inertia * push.spin * mean.spin : 0.0;
        return body.mass * push.velocity.dot(mean.velocity) + turned;
    };
    forced += workOf(kick.forced);
    damped += workOf(kick.damped);
    friction += workOf(kick.friction);
    fields += body.mass * (kick.kept.velocity - base + kick.forced.velocity);
    dampedMomentum += body.mass * kick.damped.velocity;
    frictionMomentum += body.mass * kick.friction.velocity;
}

FieldAccount& FieldAccount::operator+=(const FieldAccount& other) {
    forced += other.forced;
    damped += other.damped;
    friction += other.friction;
    fields += other.fields;
    dampedMomentum += other.dampedMomentum;
    frictionMomentum += other.frictionMomentum;
    return *this;
}

FieldIndex FieldStore::acquire() {
    if (free.empty()) {
        records.emplace_back();
        return static_cast<FieldIndex>(records.size() - 1);
    }
    const FieldIndex field = free.back();
    free.pop_back();
    return field;
}

void FieldStore::release(FieldIndex field) {
    const std::uint32_t generation = records[field].generation + 1;
    records[field] = {};
    records[field].generation = generation;
    free.push_back(field);
}

}  // namespace plumb
