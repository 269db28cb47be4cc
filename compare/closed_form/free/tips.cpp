// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/one_formula.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <compare/closed_form/motion.h>
#include <compare/formula/pendulum.h>

namespace plumb::compare {
namespace {

constexpr double touches = 1e-6;      // a corner closer than this to a face stands on it [m]
constexpr int looksForCorner = 1000;  // the number of moments at which the corner's hold is checked

/// The face that it stands on, and the corners at the ends of its base, from the centre of mass.
struct Stand {
    const Face* face = nullptr;
    Vec2 low{0, 0}, high{0, 0};
};

std::optional<Stand> standOf(const FreeBody& body) {
    for (const Face& face : body.obstacles.faces) {
        if (face.normal.dot(body.flight.position) - face.offset < touches) continue;  // it is on the other side
        const Vec2 along = tangentOf(face.normal);
        std::optional<Stand> stand;
        for (const Vec2& corner : body.hull) {
            if (std::abs(face.normal.dot(body.flight.position + corner) - face.offset) > touches) continue;
            if (!stand) stand = Stand{&face, corner, corner};
            if (along.dot(corner) < along.dot(stand->low)) stand->low = corner;
            if (along.dot(corner) > along.dot(stand->high)) stand->high = corner;
        }
        if (stand && along.dot(stand->high - stand->low) > touches) return stand;
    }
    return {};
}

/// The angle by which it turns about a corner until another corner comes down, on the side to which it falls (1 or -1
/// along).
double turnToSide(const FreeBody& body, const Stand& stand, const Vec2& pivot, double side) {
    const Vec2 along = side * tangentOf(stand.face->normal);
    double least = std::numbers::pi;
    for (const Vec2& corner : body.hull) {
        const Vec2 arm = corner - pivot;
        if (arm.norm() < touches) continue;
        least = std::min(least, std::atan2(stand.face->normal.dot(arm), along.dot(arm)));
    }
    return least;
}

double timeOfTurn(const PendulumMotion& swing, double turn) {
    const Pendulum pendulum{swing.equivalentLength, swing.gravity, swing.amplitude};
    double low = 0, high = periodOf(pendulum) / 2;
    for (double middle = high / 2; middle > low && middle < high; middle = (low + high) / 2)
        (std::abs(swingAt(pendulum, middle).angle - swing.amplitude) < turn ? low : high) = middle;
    return high;
}

/// Friction must be able to give the force at the corner. The force is divided by the mass.
void refuseSlip(const FreeBody& body, const Stand& stand, const PendulumMotion& swing, double until) {
    const double friction = lawOf(*stand.face->surface.def, *body.surface.def).friction;
    const Vec2 along = tangentOf(stand.face->normal);
    for (int i = 0; i < looksForCorner; ++i) {
        const BodyState state = motionState(swing, body.scene->def, until * i / looksForCorner);
        const Vec2 arm = state.position - swing.pivot;
        const double spin = state.angularVelocity;
        const double gain = cross(arm, body.gravity) / (swing.equivalentLength * swing.length);
        const Vec2 force = gain * perp(arm) - spin * spin * arm - body.gravity;
        if (std::abs(force.dot(along)) > friction * force.dot(stand.face->normal))
            notKnown(body.scene->name, "it tips over, and its corner slips");
    }
}

}  // namespace

std::optional<WorkedMotion> tippingMotion(const Scene& scene, const FreeBody& body) {
    const BodyDef& def = body.scene->def;
    const bool still = def.velocity == Vec2(0, 0) && def.angularVelocity == 0;
    if (body.radius || body.hull.empty() || body.inverseInertia == 0 || !still || body.skin > 0) return {};
    const std::optional<Stand> stand = standOf(body);
    if (!stand || stand->face->velocity != Vec2(0, 0) || stand->face->turns) return {};
    const Vec2 along = tangentOf(stand->face->normal);
    const double pressure = -body.gravity.dot(stand->face->normal), pull = body.gravity.dot(along);
    if (pressure <= 0 || std::abs(pull) > lawOf(*stand->face->surface.def, *body.surface.def).friction * pressure)
        return {};
    const double height = -stand->low.dot(stand->face->normal), pressedAt = height * pull / pressure;
    const bool right = pressedAt > along.dot(stand->high);
    if (!right && pressedAt >= along.dot(stand->low)) return {};
    for (const SceneBody& other : scene.bodies)
        if (&other != body.scene && other.def.type == BodyType::Dynamic && mayTouch(other.def, def))
            notKnown(body.scene->name, "it tips over, and may meet " + other.name);
    if (body.gravity.x() != 0) notKnown(body.scene->name, "it tips over, and gravity is not straight down");
    if (body.center != Vec2(0, 0)) notKnown(body.scene->name, "it tips over, and its origin is not its centre of mass");
    const Vec2 corner = right ? stand->high : stand->low, arm = -corner;
    const double length = arm.norm();
    const PendulumMotion swing{.body = body.scene->name,
                               .pivot = body.flight.position + corner,
                               .length = length,
                               .equivalentLength = length + body.inverseMass / (body.inverseInertia * length),
                               .gravity = -body.gravity.y(),
                               .amplitude = std::atan2(arm.x(), -arm.y()),
                               .bodyAngle = def.angle};
    const double until = timeOfTurn(swing, turnToSide(body, *stand, corner, right ? 1 : -1));
    const double asked = scene.closedForm->until > 0 ? std::min(until, scene.closedForm->until) : until;
    refuseSlip(body, *stand, swing, asked);
    return WorkedMotion{swing, until};
}

}  // namespace plumb::compare
