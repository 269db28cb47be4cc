// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/one_formula.h>

#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/motion.h>

namespace plumb::compare {
namespace {

constexpr int looks = 4096;  // the number of places on its way that are checked for obstacles

double distanceTo(const Face& face, const Vec2& point, double time) {
    const Vec2 place = point - face.velocity * time, along = tangentOf(face.normal);
    const double at = std::clamp(along.dot(place), face.low, face.high);
    return (place - at * along - face.offset * face.normal).norm();
}

void refuseMeetings(const Scene& scene, const FreeBody& body, const BodyMotion& motion) {
    const std::string& name = body.scene->name;
    for (const SceneBody& other : scene.bodies)
        if (&other != body.scene && other.def.type == BodyType::Dynamic && mayTouch(other.def, body.scene->def))
            notKnown(name, "air or damping holds it back, and it may meet " + other.name);
    for (int i = 0; i <= looks; ++i) {
        const double time = scene.duration * i / looks;
        const Vec2 place = motionState(motion, body.scene->def, time).position;
        for (const Face& face : body.obstacles.faces)
            if (distanceTo(face, place, time) < body.reach)
                notKnown(name, "air or damping holds it back, and it meets " + scene.bodies[face.surface.body].name);
        for (const Corner& corner : body.obstacles.corners)
            if ((place - corner.position - corner.velocity * time).norm() < body.reach + corner.radius)
                notKnown(name, "air or damping holds it back, and it meets " + scene.bodies[corner.surface.body].name);
    }
}

}  // namespace

std::optional<WorkedMotion> motionInAir(const Scene& scene, const FreeBody& body) {
    const SceneBody& own = *body.scene;
    if (own.def.type != BodyType::Dynamic || !own.def.enabled) return {};
    const Air air = airAt(scene, own.def);
    const double damping = own.def.linearDamping;
    if (air.linear + air.quadratic + damping == 0) return {};
    if (body.center != Vec2(0, 0)) notKnown(own.name, "air or damping holds it back off its origin");
    std::optional<BodyMotion> motion;
    if (air.quadratic == 0 && (air.linear == 0 || damping == 0)) {
        const double k = damping > 0 ? damping : air.linear * body.inverseMass;
        const Vec2 wind = damping > 0 ? Vec2(0, 0) : air.wind;
        motion = DampedFlight{own.name, own.def.position, own.def.velocity, body.gravity + k * wind, k};
    } else if (air.linear + damping == 0 && air.wind == Vec2(0, 0) && own.def.velocity == Vec2(0, 0) &&
               own.def.angularDamping == 0 && body.gravity.x() == 0 && body.gravity.y() < 0) {
        const double g = -body.gravity.y();
        motion = DragFall{own.name, own.def.position, std::sqrt(g / (air.quadratic * body.inverseMass)), g};
    }
    if (!motion) notKnown(own.name, "air holds it back by the square of its speed, and not from rest alone");
    refuseMeetings(scene, body, *motion);
    return WorkedMotion{*motion};
}

}  // namespace plumb::compare
