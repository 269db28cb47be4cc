// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/field_pull.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/placed_outline.h>
#include <plumb/dynamics/detail/quarantine.h>

namespace plumb {

namespace {

bool letsIn(const FieldRecord& field, const WorldState& world, BodyIndex body) {
    if (!field.choosy) return true;
    const Filter& f = field.def.filter;
    const Gate gate{f.category, f.mask, 0, f.group, false, false};
    const std::vector<ProxyId>& proxies = world.bodies.record[body].proxies;
    return std::any_of(proxies.begin(), proxies.end(),
                       [&](ProxyId proxy) { return mayMeet(gate, world.space.gate(proxy)); });
}

bool covers(const FieldDef& field, const Vec2& point) {
    return !field.region || distance(Circle{1e-9, point}, {}, *field.region, {}).separation <= 1e-9;
}

/// Does it act on a body that is there?
bool actsOn(const FieldRecord& field, const WorldState& world, BodyIndex body, const BodyMotion& there) {
    return world.bodies.canMove(body) && isSound(there) && letsIn(field, world, body) &&
           covers(field.def, there.center);
}

bool hasEnergy(const FieldDef& field) {
    return !field.region && !std::holds_alternative<Drag>(field.law) &&
           !std::holds_alternative<GroundFriction>(field.law);
}

Vec2 pointOn(const BodyRecord& record, const BodyMotion& motion, const Vec2& local) {
    return motion.center + motion.rotation * Vec2(local - record.localCenter);
}

Attractor attractorOf(const Magnet& magnet, const WorldState& world, const std::vector<BodyMotion>& now) {
    Attractor attractor = magnet.pull;
    const BodyIndex body = magnet.body.index;
    attractor.center = pointOn(world.bodies.record[body], now[body], magnet.pull.center);
    return attractor;
}

/// Is what carries it still there?
bool isCarried(const Magnet& magnet, const WorldState& world) {
    const BodyRecord& record = world.bodies.record[magnet.body.index];
    return record.alive && record.generation == magnet.body.generation;
}

bool isCarriedBy(const FieldLaw& law, BodyIndex body) {
    const auto* magnet = std::get_if<Magnet>(&law);
    return magnet && magnet->body.index == body;
}

/// Calls visit(part) for the part of each shape of a body that is under water.
template <class Visit>
void forEachSubmerged(const WorldState& world, BodyIndex body, const BodyMotion& motion, const Fluid& fluid,
                      Visit&& visit) {
    const BodyRecord& record = world.bodies.record[body];
    for (const ProxyId proxy : record.proxies) {
        const ShapeDef& def = world.space[proxy].def;
        const PlacedOutline outline = placedOutline(def.shape, record, motion);
        if (def.sensor || !outline.hasArea) continue;
        const Submerged part = submergedPart(outline.corners, outline.radius, fluid);
        if (part.area > 0) visit(part);
    }
}

/// What one field adds to the pull on one body.
class Puller {
public:
    Puller(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull)
        : world_(world), body_(body), now_(now), record_(world.bodies.record[body]), pull_(pull) {}

    void add(const FieldRecord& field) {
        field_ = &field;
        if (const auto* magnet = std::get_if<Magnet>(&field.def.law)) {
            if (isCarried(*magnet, world_)) pull(*magnet);
            return;
        }
        if (actsOn(field, world_, body_, motion())) std::visit([this](const auto& law) { pull(law); }, field.def.law);
    }

private:
    const BodyMotion& motion() const { return now_[body_]; }

    void push(const Vec2& force, const Vec2& at) {
        Acceleration a{force * record_.inverseMass, cross(Vec2(at - motion().center), force) * record_.inverseInertia};
        pull_.acceleration.linear += a.linear;
        pull_.acceleration.angular += a.angular;
        if (hasEnergy(field_->def)) return;
        pull_.unaccounted.linear += a.linear;
        pull_.unaccounted.angular += a.angular;
    }
    void pushCenter(const Vec2& force) { push(force, motion().center); }

    void pull(const UniformGravity& law) { pushCenter(gravityForce(law, record_.mass)); }

    void pull(const MutualGravity& law) {
        const PointMass self{record_.mass, motion().center};
        for (BodyIndex other = 1; other < now_.size(); ++other) {
            if (other == body_ || !actsOn(*field_, world_, other, now_[other])) continue;
            pushCenter(gravityForce(law, {world_.bodies.record[other].mass, now_[other].center}, self));
        }
    }

    void pull(const Attractor& law) { pushCenter(attraction(law, motion().center)); }

    /// The one that carries it bears what the others feel.
    void pull(const Magnet& law) {
        const Attractor attractor = attractorOf(law, world_, now_);
        if (law.body.index != body_) {
            if (actsOn(*field_, world_, body_, motion())) pull(attractor);
            return;
        }
        if (!world_.bodies.canMove(body_)) return;
        for (BodyIndex other = 1; other < now_.size(); ++other)
            if (other != body_ && actsOn(*field_, world_, other, now_[other]))
                push(-attraction(attractor, now_[other].center), attractor.center);
    }

    void pull(const Pool& law) {
        forEachSubmerged(world_, body_, motion(), law.fluid, [&](const Submerged& part) {
            push(buoyancyForce(law.fluid, part), part.centroid);
            slow(law.drag * part.area * record_.inverseMass, law.flow);
            pull_.turning += law.drag * part.area * record_.inverseMass;
        });
    }

    void pull(const Drag& law) {
        slow(law.linear * record_.inverseMass, law.wind);
        if (law.quadratic > 0) pull_.quadratic.push_back({law.quadratic * record_.inverseMass, law.wind});
    }

    void slow(double rate, const Vec2& flow) {
        pull_.linear += rate;
        pull_.flow += rate * flow;
    }

    void pull(const GroundFriction& law) {
        const double lever = law.lever > 0 ? law.lever : 2.0 / 3 * std::sqrt(2 * record_.inertia * record_.inverseMass);
        pull_.friction += law.friction * law.gravity;
        pull_.spinFriction += law.friction * law.gravity * lever * record_.mass * record_.inverseInertia;
    }

    const WorldState& world_;
    BodyIndex body_;
    const std::vector<BodyMotion>& now_;
    const BodyRecord& record_;
    FieldPull& pull_;
    const FieldRecord* field_ = nullptr;
};

double mutualEnergy(const WorldState& world, const FieldRecord& field, const MutualGravity& law) {
    double sum = 0;
    const std::vector<BodyMotion>& now = world.bodies.motion;
    const auto massOf = [&](BodyIndex body) { return PointMass{world.bodies.record[body].mass, now[body].center}; };
    for (BodyIndex a = 1; a < now.size(); ++a) {
        if (!actsOn(field, world, a, now[a])) continue;
        for (BodyIndex b = a + 1; b < now.size(); ++b)
            if (actsOn(field, world, b, now[b])) sum += potentialEnergy(law, massOf(a), massOf(b));
    }
    return sum;
}

double mutualEnergy(const WorldState& world, const FieldRecord& field, const MutualGravity& law, BodyIndex body,
                    const BodyMotion& there) {
    double sum = 0;
    const std::vector<BodyMotion>& now = world.bodies.motion;
    const PointMass self{world.bodies.record[body].mass, there.center};
    for (BodyIndex other = 1; other < now.size(); ++other)
        if (other != body && actsOn(field, world, other, now[other]))
            sum += potentialEnergy(law, {world.bodies.record[other].mass, now[other].center}, self);
    return sum;
}

/// Of all that act on each body by itself.
double energyIn(const WorldState& world, const FieldLaw& law, BodyIndex body, const BodyMotion& motion) {
    if (const auto* uniform = std::get_if<UniformGravity>(&law))
        return potentialEnergy(*uniform, world.bodies.record[body].mass, motion.center);
    if (const auto* attractor = std::get_if<Attractor>(&law)) return potentialEnergy(*attractor, motion.center);
    if (const auto* magnet = std::get_if<Magnet>(&law))
        return potentialEnergy(attractorOf(*magnet, world, world.bodies.motion), motion.center);
    double sum = 0;
    if (const auto* pool = std::get_if<Pool>(&law))
        forEachSubmerged(world, body, motion, pool->fluid,
                         [&](const Submerged& part) { sum += potentialEnergy(pool->fluid, part); });
    return sum;
}

/// Calls visit(body) for each body that a field acts on, asleep or awake.
template <class Visit>
void forEachFeeling(const WorldState& world, const FieldRecord& field, Visit&& visit) {
    const auto* magnet = std::get_if<Magnet>(&field.def.law);
    if (magnet && !isCarried(*magnet, world)) return;
    for (BodyIndex body = 1; body < world.bodies.record.size(); ++body) {
        if (isCarriedBy(field.def.law, body)) continue;
        if (actsOn(field, world, body, world.bodies.motion[body])) visit(body);
    }
}

bool mayDraw(const WorldState& world, const FieldDef& field) {
    if (const auto* magnet = std::get_if<Magnet>(&field.law))
        return isCarried(*magnet, world) && world.bodies.record[magnet->body.index].awake;
    return std::holds_alternative<MutualGravity>(field.law);
}

}  // namespace

FieldPull pullOn(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now) {
    FieldPull pull;
    Puller puller(world, body, now, pull);
    for (const FieldRecord& field : world.fields.records)
        if (field.alive) puller.add(field);
    return pull;
}

double fieldEnergyOf(const WorldState& world) {
    double sum = 0;
    for (const FieldRecord& field : world.fields.records) {
        if (!field.alive || !hasEnergy(field.def)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(world, field, *mutual);
        else
            forEachFeeling(world, field, [&](BodyIndex body) {
                sum += energyIn(world, field.def.law, body, world.bodies.motion[body]);
            });
    }
    return sum;
}

double fieldEnergyOf(const WorldState& world, BodyIndex body, const BodyMotion& there) {
    double sum = 0;
    for (const FieldRecord& field : world.fields.records) {
        if (!field.alive || !hasEnergy(field.def) || !actsOn(field, world, body, there)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(world, field, *mutual, body, there);
        else if (!isCarriedBy(field.def.law, body))
            sum += energyIn(world, field.def.law, body, there);
    }
    return sum;
}

void wakeWhatIsDrawn(WorldState& world) {
    for (const FieldRecord& field : world.fields.records) {
        if (!field.alive || !mayDraw(world, field.def)) continue;
        const auto* magnet = std::get_if<Magnet>(&field.def.law);
        const Attractor reach = magnet ? attractorOf(*magnet, world, world.bodies.motion) : Attractor{};
        forEachFeeling(world, field, [&](BodyIndex body) {
            const bool near = (world.bodies.motion[body].center - reach.center).norm() <= reach.range;
            if (near || !magnet) wakeIsland(world, body);
        });
    }
}

void wakeWhatFeels(WorldState& world, const FieldRecord& field) {
    std::vector<BodyIndex> feeling;
    forEachFeeling(world, field, [&](BodyIndex body) { feeling.push_back(body); });
    if (const auto* magnet = std::get_if<Magnet>(&field.def.law))
        if (isCarried(*magnet, world)) feeling.push_back(magnet->body.index);
    for (const BodyIndex body : feeling) wakeIsland(world, body);
}

}  // namespace plumb
