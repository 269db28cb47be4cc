// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_scope.h>

#include <algorithm>
#include <limits>

#include <plumb/collide/distance.h>

namespace plumb {

namespace {

/// A body counts if one of its shapes does. Pieces that serve neither contacts nor queries are left out.
bool passesFilter(const FieldRecord& field, const FieldStores& view, BodyIndex body) {
    if (!field.filters) return true;
    const Filter& f = field.def.filter;
    const FilterKey filterKey{f.category, f.mask, 0, f.group, false, false};
    const std::vector<ProxyId>& proxies = view.bodies.links[body].proxies;
    return std::any_of(proxies.begin(), proxies.end(), [&](ProxyId proxy) {
        return filtersAllow(filterKey, view.space.filterKey(proxy)) && view.space[proxy].use != PieceUse::None;
    });
}

/// In the region, or within 1e-9 m of it [m]: what is put exactly on the edge is inside, however its coordinates round.
/// A disc of that radius stands for the point, as distance needs a shape.
bool covers(const FieldDef& field, const Vec2& point) {
    return !field.region || distance(Circle{1e-9, point}, {}, *field.region, {}).separation <= 1e-9;
}

Vec2 pointOn(const BodyRecord& record, const BodyMotion& motion, const Vec2& local) {
    return motion.center + motion.rotation * Vec2(local - record.localCenter);
}

/// Does a body reach the surface of the fluid from above? The surface is a line through a point, at right angles to
/// gravity; the test takes the body as a disc around its centre of mass, and so errs on the safe side.
bool dips(const BodyRecord& record, const Vec2& center, const Fluid& fluid) {
    return fluid.gravity.dot(fluid.surface - center) <= record.boundingRadius * fluid.gravity.norm();
}

/// May something that moves between two places come within range of a centre? By the disc around both places: it may
/// say yes to what passes by, and then the field's force there is 0.
bool comesNear(const Vec2& center, double range, const Vec2& from, const Vec2& to) {
    return (0.5 * (from + to) - center).norm() <= range + 0.5 * (to - from).norm();
}

/// May something that moves within a box come into a field's region?
bool mayReach(const FieldStores& view, const FieldRecord& field, const Aabb& way) {
    if (!field.def.region || !view.bodies.wrap.any()) return overlap(way, field.box);
    bool reaches = false;
    view.space.forEachShift(field.box, way, [&](const Vec2&) { reaches = true; });
    return reaches;
}

/// May a field act on a body somewhere between two places? Asked once a step for each field and awake body, so cheap
/// tests come first. A yes costs time only; but a body that gets a no moves by its closed form, bit for bit as if there
/// were no field. Test: "a field far away changes no bit of what it does not reach"
bool mayInfluence(const FieldStores& view, const FieldRecord& field, BodyIndex body, const Vec2& from, const Vec2& to) {
    const auto* magnet = std::get_if<Magnet>(&field.def.law);
    if (magnet && !isCarried(*magnet, view)) return false;
    if (isCarriedBy(field.def.law, body)) return true;
    if (!passesFilter(field, view, body)) return false;
    if (!mayReach(view, field, merge({from, from}, {to, to}))) return false;
    if (magnet) {
        const BodyMotion& carrier = view.bodies.motion[magnet->body.index];
        // How far the carrier may come in the step [m], with a factor of 2 to spare.
        const double moves = 2 * carrier.velocity.norm() * view.bodies.lastStep;
        const Vec2 center = pointOn(view.bodies.record[magnet->body.index], carrier, magnet->pull.center);
        return comesNear(view.bodies.near(center, 0.5 * (from + to)), magnet->pull.range + moves, from, to);
    }
    if (const auto* attractor = std::get_if<Attractor>(&field.def.law))
        return comesNear(view.bodies.near(attractor->center, 0.5 * (from + to)), attractor->range, from, to);
    if (const auto* pool = std::get_if<Pool>(&field.def.law)) {
        const BodyRecord& record = view.bodies.record[body];
        // Which copy of the surface acts depends on the place along the path: pullOn finds that out.
        if (view.bodies.wrap.any()) return true;
        return dips(record, from, pool->fluid) || dips(record, to, pool->fluid);
    }
    return true;
}

/// The same force at each place and time, and linear in the velocity: then free motion has a closed form. A region has
/// an edge, where that ends.
bool isSteady(const FieldDef& field) {
    if (field.region) return false;
    const auto* drag = std::get_if<Drag>(&field.law);
    return (drag && drag->quadratic == 0) || std::holds_alternative<UniformGravity>(field.law);
}

/// Fields whose force depends on where other bodies are: these bodies must be moved with the flight that is predicted.
bool attractsOthers(const FieldDef& field) {
    return std::holds_alternative<MutualGravity>(field.law) || std::holds_alternative<Magnet>(field.law);
}

bool keepsAwake(const FieldStores& view, const FieldDef& field) {
    if (const auto* magnet = std::get_if<Magnet>(&field.law)) return view.bodies.record[magnet->body.index].awake;
    return true;
}

}  // namespace

Aabb boxOf(const FieldDef& field) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!field.region) return {{-infinity, -infinity}, {infinity, infinity}};
    const Aabb box = aabbOf(*field.region, {});
    // The margin covers the tolerance of covers(), and the rounding of large coordinates.
    return inflate(box, 1e-8 + 1e-12 * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff());
}

std::optional<Vec2> shiftInto(const FieldRecord& field, const FieldStores& view, const Vec2& point) {
    const Wrap& wrap = view.bodies.wrap;
    if (!wrap.any()) return covers(field.def, point) ? std::optional<Vec2>(Vec2(0, 0)) : std::nullopt;
    std::optional<Vec2> found;
    if (field.def.region) {
        view.space.forEachShift(field.box, {point, point}, [&](const Vec2& shift) {
            if (!found && covers(field.def, point + shift)) found = shift;
        });
    } else if (const auto* attractor = std::get_if<Attractor>(&field.def.law)) {
        found = wrap.shiftNear(point, attractor->center);
    } else {
        found = std::holds_alternative<Pool>(field.def.law) ? Vec2(wrap.place(point) - point) : Vec2(0, 0);
    }
    return found;
}

bool actsOn(const FieldRecord& field, const FieldStores& view, BodyIndex body, const BodyMotion& there) {
    return view.bodies.canMove(body) && isInRange(there) && passesFilter(field, view, body) &&
           shiftInto(field, view, there.center).has_value();
}

Attractor attractorOf(const Magnet& magnet, const FieldStores& view, const std::vector<BodyMotion>& now) {
    Attractor attractor = magnet.pull;
    const BodyIndex body = magnet.body.index;
    attractor.center = pointOn(view.bodies.record[body], now[body], magnet.pull.center);
    return attractor;
}

bool isCarried(const Magnet& magnet, const FieldStores& view) {
    const BodyRecord& record = view.bodies.record[magnet.body.index];
    return record.alive && record.enabled && record.generation == magnet.body.generation;
}

bool isCarriedBy(const FieldLaw& law, BodyIndex body) {
    const auto* magnet = std::get_if<Magnet>(&law);
    return magnet && magnet->body.index == body;
}

bool dependsOnOtherBodies(const FieldStore& fields) {
    return std::any_of(fields.records.begin(), fields.records.end(),
                       [](const FieldRecord& field) { return field.alive && attractsOthers(field.def); });
}

FieldInfluence influenceOn(const FieldStores& view, BodyIndex body, const Vec2& from, const Vec2& to) {
    FieldInfluence influence = FieldInfluence::None;
    for (const FieldRecord& field : view.fields.records) {
        if (!field.alive || !mayInfluence(view, field, body, from, to)) continue;
        if (!isSteady(field.def)) return FieldInfluence::Varying;
        influence = FieldInfluence::Steady;
    }
    return influence;
}

/// O(all bodies), sleeping ones, too: called when a field is added or changed, for energies, and in each step for
/// mutual gravity and magnets.
StepList<BodyIndex> bodiesInfluencedBy(const FieldStores& view, const FieldRecord& field) {
    StepList<BodyIndex> influenced;
    for (BodyIndex body = 1; body < view.bodies.record.size(); ++body) {
        if (isCarriedBy(field.def.law, body)) continue;
        const BodyMotion& motion = view.bodies.motion[body];
        if (actsOn(field, view, body, motion) && mayInfluence(view, field, body, motion.center, motion.center))
            influenced.push_back(body);
    }
    return influenced;
}

/// In the predict phase of a step, for each field. The list is gathered once, because each of its bodies goes through
/// it in each sub-step: O(n^2) of mutual gravity.
StepList<BodyIndex> gatherAttracted(FieldStore& fields, FieldIndex index, const BodyStore& bodies, const Space& space) {
    const FieldStores view{fields, bodies, space};
    FieldRecord& field = fields.records[index];
    field.attracted.clear();
    if (!field.alive || !attractsOthers(field.def)) return {};
    for (BodyIndex body = 1; body < bodies.record.size(); ++body)
        if (bodies.canMove(body) && passesFilter(field, view, body)) field.attracted.push_back(body);
    return keepsAwake(view, field.def) ? bodiesInfluencedBy(view, field) : StepList<BodyIndex>();
}

}  // namespace plumb
