// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/field_pull.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/placed_outline.h>
#include <plumb/dynamics/detail/quarantine.h>
#include <plumb/forces/detail/gravity_force.h>
#include <plumb/forces/detail/submerged.h>

namespace plumb {

namespace {

bool letsIn(const FieldRecord& field, const WorldState& world, BodyIndex body) {
    if (!field.choosy) return true;
    const Filter& f = field.def.filter;
    const Gate gate{f.category, f.mask, 0, f.group, false, false};
    const std::vector<ProxyId>& proxies = world.bodies.record[body].proxies;
    return std::any_of(proxies.begin(), proxies.end(), [&](ProxyId proxy) {
        return mayMeet(gate, world.space.gate(proxy)) && world.space[proxy].use != PieceUse::None;
    });
}

bool covers(const FieldDef& field, const Vec2& point) {
    return !field.region || distance(Circle{1e-9, point}, {}, *field.region, {}).separation <= 1e-9;
}

/// So many rounds bring a point to where a field sees it, in a world that wraps: into its region, or else near its
/// centre, or to where a pool without a region has its depth. Empty when the field does not cover it.
std::optional<Vec2> shiftInto(const FieldRecord& field, const WorldState& world, const Vec2& point) {
    const Wrap& wrap = world.def.wrap;
    if (!wrap.any()) return covers(field.def, point) ? std::optional<Vec2>(Vec2(0, 0)) : std::nullopt;
    std::optional<Vec2> found;
    if (field.def.region) {
        world.space.forEachShift(field.box, {point, point}, [&](const Vec2& shift) {
            if (!found && covers(field.def, point + shift)) found = shift;
        });
    } else if (const auto* attractor = std::get_if<Attractor>(&field.def.law)) {
        found = wrap.shiftNear(point, attractor->center);
    } else {
        found = std::holds_alternative<Pool>(field.def.law) ? Vec2(wrap.place(point) - point) : Vec2(0, 0);
    }
    return found;
}

/// Does it act on a body that is there?
bool actsOn(const FieldRecord& field, const WorldState& world, BodyIndex body, const BodyMotion& there) {
    return world.bodies.canMove(body) && isSound(there) && letsIn(field, world, body) &&
           shiftInto(field, world, there.center).has_value();
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

/// Is what carries it there?
bool isCarried(const Magnet& magnet, const WorldState& world) {
    const BodyRecord& record = world.bodies.record[magnet.body.index];
    return record.alive && record.enabled && record.generation == magnet.body.generation;
}

bool isCarriedBy(const FieldLaw& law, BodyIndex body) {
    const auto* magnet = std::get_if<Magnet>(&law);
    return magnet && magnet->body.index == body;
}

/// A fluid as seen from a body's centre of mass, along its axes.
Fluid seenFrom(const BodyMotion& motion, const Fluid& fluid) {
    const Rot back = motion.rotation.inverse();
    return {fluid.density, back * Vec2(fluid.surface - motion.center), back * fluid.gravity};
}

/// Calls visit(part) for the part of each shape of a body that is under water. Looked at in the body's frame, where the
/// shapes are as sound as when they were taken in, however far off it is.
template <class Visit>
void forEachSubmerged(const WorldState& world, BodyIndex body, const BodyMotion& motion, const Fluid& fluid,
                      Visit&& visit) {
    const BodyRecord& record = world.bodies.record[body];
    const Fluid seen = seenFrom(motion, fluid);
    for (const ProxyId proxy : record.proxies) {
        const ShapeDef& def = world.space[proxy].def;
        const PlacedOutline outline = placedOutline(def.shape, record, {});
        if (def.sensor || !outline.hasArea) continue;
        Submerged part = submergedPartOf(outline.corners, outline.radius, seen);
        part.centroid = motion.center + motion.rotation * part.centroid;
        if (part.area > 0) visit(part);
    }
}

/// Does a body come as low as the surface?
bool dips(const BodyRecord& record, const Vec2& center, const Fluid& fluid) {
    return fluid.gravity.dot(fluid.surface - center) <= record.extent * fluid.gravity.norm();
}

/// May something on its way between two places come as near to a centre?
bool comesNear(const Vec2& center, double range, const Vec2& from, const Vec2& to) {
    return (0.5 * (from + to) - center).norm() <= range + 0.5 * (to - from).norm();
}

/// May something on its way come into a field's region?
bool mayReach(const WorldState& world, const FieldRecord& field, const Aabb& way) {
    if (!field.def.region || !world.def.wrap.any()) return overlap(way, field.box);
    bool reaches = false;
    world.space.forEachShift(field.box, way, [&](const Vec2&) { reaches = true; });
    return reaches;
}

/// May a field act on a body somewhere between two places?
bool mayFeel(const WorldState& world, const FieldRecord& field, BodyIndex body, const Vec2& from, const Vec2& to) {
    const auto* magnet = std::get_if<Magnet>(&field.def.law);
    if (magnet && !isCarried(*magnet, world)) return false;
    if (isCarriedBy(field.def.law, body)) return true;
    if (!letsIn(field, world, body)) return false;
    if (!mayReach(world, field, merge({from, from}, {to, to}))) return false;
    if (magnet) {
        const BodyMotion& carrier = world.bodies.motion[magnet->body.index];
        const double moves = 2 * carrier.velocity.norm() * world.lastStep;
        const Vec2 center = pointOn(world.bodies.record[magnet->body.index], carrier, magnet->pull.center);
        return comesNear(world.bodies.near(center, 0.5 * (from + to)), magnet->pull.range + moves, from, to);
    }
    if (const auto* attractor = std::get_if<Attractor>(&field.def.law))
        return comesNear(world.bodies.near(attractor->center, 0.5 * (from + to)), attractor->range, from, to);
    if (const auto* pool = std::get_if<Pool>(&field.def.law)) {
        const BodyRecord& record = world.bodies.record[body];
        if (world.def.wrap.any()) return true;
        return dips(record, from, pool->fluid) || dips(record, to, pool->fluid);
    }
    return true;
}

bool isSteady(const FieldDef& field) {
    if (field.region) return false;
    const auto* drag = std::get_if<Drag>(&field.law);
    return (drag && drag->quadratic == 0) || std::holds_alternative<UniformGravity>(field.law);
}

bool drawsOthers(const FieldDef& field) {
    return std::holds_alternative<MutualGravity>(field.law) || std::holds_alternative<Magnet>(field.law);
}

/// What one field adds to the pull on one body.
class Puller {
public:
    Puller(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull)
        : world_(world), body_(body), now_(now), record_(world.bodies.record[body]), pull_(pull) {}

    void add(const FieldRecord& field) {
        field_ = &field;
        there_ = now_[body_];
        if (const auto* magnet = std::get_if<Magnet>(&field.def.law)) {
            if (isCarried(*magnet, world_)) pull(*magnet);
            return;
        }
        if (!actsOn(field, world_, body_, motion())) return;
        there_.center += *shiftInto(field, world_, there_.center);
        std::visit([this](const auto& law) { pull(law); }, field.def.law);
    }

private:
    /// As the field sees it.
    const BodyMotion& motion() const { return there_; }

    /// Of what the field's filter lets in.
    bool isWithin(BodyIndex other) const {
        return isSound(now_[other]) && shiftInto(*field_, world_, now_[other].center).has_value();
    }
    Vec2 nearTo(const Vec2& place, const Vec2& other) const { return world_.bodies.near(place, other); }

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
        Vec2 sum(0, 0);
        for (const BodyIndex other : field_->drawn)
            if (other != body_ && isWithin(other))
                sum += gravityForceOf(
                    law, {world_.bodies.record[other].mass, nearTo(now_[other].center, self.position)}, self);
        pushCenter(sum);
    }

    void pull(const Attractor& law) { pushCenter(attraction(law, motion().center)); }

    /// The one that carries it bears what the others feel.
    void pull(const Magnet& law) {
        Attractor attractor = attractorOf(law, world_, now_);
        attractor.center = nearTo(attractor.center, motion().center);
        if (law.body.index != body_) {
            if (actsOn(*field_, world_, body_, motion())) pull(attractor);
            return;
        }
        if (!world_.bodies.canMove(body_)) return;
        for (const BodyIndex other : field_->drawn)
            if (other != body_ && isWithin(other))
                push(-attraction(attractor, nearTo(now_[other].center, attractor.center)), attractor.center);
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
    BodyMotion there_;
};

/// At one place, or too near for numbers, there is no force; so no energy is told.
double finite(double energy) {
    return std::isfinite(energy) ? energy : 0;
}

double mutualEnergy(const WorldState& world, const FieldRecord& field, const MutualGravity& law) {
    double sum = 0;
    const std::vector<BodyMotion>& now = world.bodies.motion;
    const auto massOf = [&](BodyIndex body) { return PointMass{world.bodies.record[body].mass, now[body].center}; };
    for (BodyIndex a = 1; a < now.size(); ++a) {
        if (!actsOn(field, world, a, now[a])) continue;
        for (BodyIndex b = a + 1; b < now.size(); ++b)
            if (actsOn(field, world, b, now[b])) {
                PointMass other = massOf(b);
                other.position = world.bodies.near(other.position, now[a].center);
                sum += finite(potentialEnergy(law, massOf(a), other));
            }
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
            sum += finite(potentialEnergy(
                law, {world.bodies.record[other].mass, world.bodies.near(now[other].center, there.center)}, self));
    return sum;
}

/// Of all that act on each body by itself.
double energyIn(const WorldState& world, const FieldRecord& field, BodyIndex body, BodyMotion motion) {
    const FieldLaw& law = field.def.law;
    motion.center += shiftInto(field, world, motion.center).value_or(Vec2(0, 0));
    if (const auto* uniform = std::get_if<UniformGravity>(&law))
        return potentialEnergy(*uniform, world.bodies.record[body].mass, motion.center);
    if (const auto* attractor = std::get_if<Attractor>(&law)) return finite(potentialEnergy(*attractor, motion.center));
    if (const auto* magnet = std::get_if<Magnet>(&law)) {
        Attractor attractor = attractorOf(*magnet, world, world.bodies.motion);
        attractor.center = world.bodies.near(attractor.center, motion.center);
        return finite(potentialEnergy(attractor, motion.center));
    }
    double sum = 0;
    if (const auto* pool = std::get_if<Pool>(&law))
        forEachSubmerged(world, body, motion, pool->fluid,
                         [&](const Submerged& part) { sum += potentialEnergy(pool->fluid, part); });
    return sum;
}

/// Calls visit(body) for each body that a field acts on, asleep or awake.
template <class Visit>
void forEachFeeling(const WorldState& world, const FieldRecord& field, Visit&& visit) {
    for (BodyIndex body = 1; body < world.bodies.record.size(); ++body) {
        if (isCarriedBy(field.def.law, body)) continue;
        const BodyMotion& motion = world.bodies.motion[body];
        if (actsOn(field, world, body, motion) && mayFeel(world, field, body, motion.center, motion.center))
            visit(body);
    }
}

bool keepsAwake(const WorldState& world, const FieldDef& field) {
    if (const auto* magnet = std::get_if<Magnet>(&field.law)) return world.bodies.record[magnet->body.index].awake;
    return true;
}

}  // namespace

void gatherDrawn(WorldState& world) {
    for (FieldRecord& field : world.fields.records) {
        field.drawn.clear();
        if (!field.alive || !drawsOthers(field.def)) continue;
        for (BodyIndex body = 1; body < world.bodies.record.size(); ++body)
            if (world.bodies.canMove(body) && letsIn(field, world, body)) field.drawn.push_back(body);
        if (keepsAwake(world, field.def))
            forEachFeeling(world, field, [&](BodyIndex body) { wakeIsland(world, body); });
    }
}

bool looksAround(const WorldState& world) {
    return std::any_of(world.fields.records.begin(), world.fields.records.end(),
                       [](const FieldRecord& field) { return field.alive && drawsOthers(field.def); });
}

Felt feltBy(const WorldState& world, BodyIndex body, const Vec2& from, const Vec2& to) {
    Felt felt = Felt::Nothing;
    for (const FieldRecord& field : world.fields.records) {
        if (!field.alive || !mayFeel(world, field, body, from, to)) continue;
        if (!isSteady(field.def)) return Felt::Somehow;
        felt = Felt::Steadily;
    }
    return felt;
}

void pullOn(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull) {
    std::vector<SpeedDrag> quadratic = std::move(pull.quadratic);  // for its room
    quadratic.clear();
    pull = {};
    pull.quadratic = std::move(quadratic);
    Puller puller(world, body, now, pull);
    for (const FieldRecord& field : world.fields.records)
        if (field.alive) puller.add(field);
}

double fieldEnergyOf(const WorldState& world) {
    double sum = 0;
    for (const FieldRecord& field : world.fields.records) {
        if (!field.alive || !hasEnergy(field.def)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(world, field, *mutual);
        else
            forEachFeeling(world, field,
                           [&](BodyIndex body) { sum += energyIn(world, field, body, world.bodies.motion[body]); });
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
            sum += energyIn(world, field, body, there);
    }
    return sum;
}

void wakeWhatFeels(WorldState& world, const FieldRecord& field) {
    std::vector<BodyIndex> feeling;
    forEachFeeling(world, field, [&](BodyIndex body) { feeling.push_back(body); });
    if (const auto* magnet = std::get_if<Magnet>(&field.def.law))
        if (isCarried(*magnet, world)) feeling.push_back(magnet->body.index);
    for (const BodyIndex body : feeling) wakeIsland(world, body);
}

void wakeWhatItDraws(WorldState& world, BodyIndex body) {
    for (const FieldRecord& field : world.fields.records)
        if (field.alive && isCarriedBy(field.def.law, body)) wakeWhatFeels(world, field);
}

Aabb boxOf(const FieldDef& field) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!field.region) return {{-infinity, -infinity}, {infinity, infinity}};
    const Aabb box = aabbOf(*field.region, {});
    // As far as covers() rounds, and what a number so large rounds to.
    return inflate(box, 1e-8 + 1e-12 * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff());
}

}  // namespace plumb
