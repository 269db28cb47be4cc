// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/free_body.h>

#include <algorithm>
#include <cmath>

#include <compare/scene/joint_geometry.h>

namespace plumb::compare {
namespace {

constexpr double aboutCenter = 1e-9;  // how near a disc's middle must be to its centre of mass [m]

/// The acceleration by gravity and uniform fields [m/s^2].
Vec2 fallOf(const Scene& scene, const SceneBody& body) {
    Vec2 fall = body.def.gravityScale * scene.gravity;
    for (const SceneField& field : scene.fields) {
        if (!actsOn(field, body)) continue;
        if (const auto* uniform = std::get_if<UniformGravity>(&field.def.law))
            fall += uniform->acceleration;
        else if (!std::holds_alternative<Drag>(field.def.law))
            notKnown(body.name, "the field " + field.name + " acts on it");
    }
    return fall;
}

void refuseHolds(const Scene& scene, const SceneBody& body) {
    for (const SceneJoint& joint : scene.joints)
        if (joint.bodyA == body.name || joint.bodyB == body.name)
            notKnown(body.name, "the joint " + joint.name + " holds it");
    if (body.def.lockX || body.def.lockY) notKnown(body.name, "it is locked");
    for (const SceneMover& mover : scene.movers)
        if (mover.body == body.name) notKnown(body.name, "the mover " + mover.name + " moves it");
}

/// Refuses other bodies that it may touch and whose motion is not known.
void refuseUnknownOthers(const Scene& scene, const SceneBody& body) {
    for (const SceneBody& other : scene.bodies) {
        if (&other == &body || other.def.type != BodyType::Dynamic) continue;
        const auto isIt = [&](const BodyMotion& motion) {
            const auto* free = std::get_if<FreeMotion>(&motion);
            return free && free->body == other.name;
        };
        if (mayTouch(body.def, other.def) && std::ranges::none_of(scene.closedForm->bodies, isIt))
            notKnown(body.name, "it may touch " + other.name + ", which is not free");
    }
}

/// The corners of a shape with an area, in its body's frame.
struct Outline {
    std::vector<Vec2> corners;
    double radius = 0;
};
Outline outlineOf(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return {{circle->center}, circle->radius};
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return {{capsule->start, capsule->end}, capsule->radius};
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return {polygon->vertices, polygon->radius};
    return {};
}

void placeShapes(FreeBody& free) {
    const BodyDef& def = free.scene->def;
    const Rot turn = Rot::fromAngle(def.angle);
    int solid = 0;
    for (std::size_t i = 0; i < def.shapes.size(); ++i) {
        if (def.shapes[i].sensor) continue;
        if (++solid == 1) free.surface = {free.index, i, &def.shapes[i]};
        const Outline outline = outlineOf(def.shapes[i].shape);
        free.skin = std::max(free.skin, outline.radius);
        for (const Vec2& corner : outline.corners) {
            free.hull.push_back(turn * Vec2(corner - free.center));
            free.reach = std::max(free.reach, free.hull.back().norm() + outline.radius);
        }
    }
    free.simple = solid == 1;
    const auto* circle = free.simple ? std::get_if<Circle>(&free.surface.def->shape) : nullptr;
    if (circle && (circle->center - free.center).norm() < aboutCenter) free.radius = circle->radius;
}

}  // namespace

bool actsOn(const SceneField& field, const SceneBody& body) {
    ShapeDef reach;
    reach.filter = field.def.filter;
    const bool all = field.def.filter == Filter{};
    const auto met = [&](ShapeDef shape) {
        shape.sensor = false;
        return mayTouch(shape, reach);
    };
    if (body.def.type != BodyType::Dynamic || !body.def.enabled) return false;
    if (!all && std::ranges::none_of(body.def.shapes, met)) return false;
    if (field.def.region) notKnown(body.name, "the field " + field.name + " ends somewhere");
    return true;
}

Air airAt(const Scene& scene, const BodyDef& def) {
    Air air;
    for (const SceneBody& body : scene.bodies) {
        if (&body.def != &def) continue;
        for (const SceneField& field : scene.fields) {
            const auto* drag = std::get_if<Drag>(&field.def.law);
            if (!drag || !actsOn(field, body)) continue;
            if (air.linear + air.quadratic > 0) notKnown(body.name, "two fields of air hold it back");
            air = {drag->linear, drag->quadratic, drag->wind};
        }
    }
    return air;
}

FreeBody freeBodyOf(const Scene& scene, const FreeMotion& motion) {
    FreeBody free;
    free.index = bodyIndex(scene, motion.body);
    free.scene = &scene.bodies[free.index];
    const BodyDef& def = free.scene->def;
    free.shortestFlight = motion.shortestFlight;
    free.flight = {
        .position = def.position, .velocity = def.velocity, .angle = def.angle, .angularVelocity = def.angularVelocity};
    if (def.type != BodyType::Dynamic || !def.enabled) {
        if (!def.enabled || def.type == BodyType::Static)
            free.flight.velocity = {0, 0}, free.flight.angularVelocity = 0;
        for (const SceneMover& mover : scene.movers)
            if (mover.body == motion.body) notKnown(motion.body, "the mover " + mover.name + " moves it");
        return free;
    }
    refuseHolds(scene, *free.scene);
    refuseUnknownOthers(scene, *free.scene);
    const Mass mass = massOf(def);
    free.inverseMass = 1 / mass.mass;
    free.inverseInertia = def.fixedRotation ? 0 : 1 / mass.inertia;
    free.center = mass.center;
    free.flight.position += Rot::fromAngle(def.angle) * mass.center;
    if (def.fixedRotation) free.flight.angularVelocity = 0;
    if (mass.center.norm() > aboutCenter && free.flight.angularVelocity != 0)
        notKnown(motion.body, "its origin turns about its centre of mass");
    free.gravity = fallOf(scene, *free.scene);
    free.obstacles = obstaclesOf(scene, def);
    placeShapes(free);
    return free;
}

}  // namespace plumb::compare
