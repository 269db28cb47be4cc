// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/free_body.h>

#include <algorithm>
#include <cmath>

#include <compare/scene/shape_pair.h>
#include <compare/scene/state.h>

namespace plumb::compare {
namespace {

constexpr double still = 1e-9;         // below this speed there is no slip [m/s]
constexpr double supportSlack = 1e-6;  // corners closer than this to a face touch it [m]

int signOf(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The start and the end of the part that touches the face, measured along the face from the centre of mass.
std::pair<double, double> baseOn(const FreeBody& body, const Face& face) {
    if (body.radius) return {0, 0};
    const Vec2 along = tangentOf(face.normal);
    double lowest = 0, from = 0, to = 0;
    for (const Vec2& corner : body.hull) lowest = std::min(lowest, face.normal.dot(corner));
    bool first = true;
    for (const Vec2& corner : body.hull) {
        if (face.normal.dot(corner) > lowest + supportSlack) continue;
        const double at = along.dot(corner);
        from = first ? at : std::min(from, at);
        to = first ? at : std::max(to, at);
        first = false;
    }
    return {from, to};
}

/// How high the centre of mass is above the face that it touches.
double heightOver(const FreeBody& body, const Face& face) {
    if (body.radius) return *body.radius;
    double lowest = 0;
    for (const Vec2& corner : body.hull) lowest = std::min(lowest, face.normal.dot(corner));
    return body.skin - lowest;
}

/// The friction along the face on a body that is pressed onto it, divided by m.
double dragAlong(const FreeBody& body, double slip, double friction, double pressure, double pull) {
    const double most = friction * pressure;
    if (std::abs(slip) > still) return -most * signOf(slip);
    const double give =
        body.radius ? 1 + *body.radius * *body.radius * body.inverseInertia / body.inverseMass : 1;  // 1 + m r^2 / I
    return std::clamp(-pull / give, -most, most);
}

}  // namespace

Flight flightAt(const Flight& flight, double time) {
    const double s = time - flight.start;
    Flight now = flight;
    now.start = time;
    now.position = flight.position + flight.velocity * s + flight.acceleration * (s * s / 2);
    now.velocity = flight.velocity + flight.acceleration * s;
    now.angle = flight.angle + flight.angularVelocity * s + flight.angularAcceleration * (s * s / 2);
    now.angularVelocity = flight.angularVelocity + flight.angularAcceleration * s;
    return now;
}

PairLaw lawOf(const ShapeDef& a, const ShapeDef& b) {
    const Material &one = a.material, &other = b.material;
    return {mixed(ruleOf(one.frictionMix, other.frictionMix), one.friction, other.friction),
            mixed(ruleOf(one.restitutionMix, other.restitutionMix), one.restitution, other.restitution),
            one.surfaceSpeed + other.surfaceSpeed};
}

void notKnown(const std::string& body, const std::string& why) {
    throw Unsupported("closedForm.bodies." + body + ": " + why + ", and no formula is known here");
}

double slipOf(const FreeBody& body, const Flight& now) {
    const Face& face = *body.face;
    const double rim = body.radius ? *body.radius * now.angularVelocity : 0;
    const double belts = lawOf(*face.surface.def, *body.surface.def).belts;
    return tangentOf(face.normal).dot(now.velocity - face.velocity) + rim - belts;
}

void setAcceleration(FreeBody& body) {
    Flight& now = body.flight;
    now.acceleration = body.gravity;
    now.angularAcceleration = 0;
    body.slipEnds.reset();
    body.pressedAt = 0;
    if (!body.face) return;
    const Face& face = *body.face;
    const Vec2 along = tangentOf(face.normal);
    const double pressure = -body.gravity.dot(face.normal), pull = body.gravity.dot(along);
    const double slip = slipOf(body, now);
    const double drag = dragAlong(body, slip, lawOf(*face.surface.def, *body.surface.def).friction, pressure, pull);
    now.acceleration = (pull + drag) * along;
    const double lever = body.radius ? *body.radius * body.inverseInertia / body.inverseMass : 0;
    now.angularAcceleration = drag * lever;
    const double gain = pull + drag + (body.radius ? *body.radius * now.angularAcceleration : 0);
    if (std::abs(slip) > still && slip * gain < 0) body.slipEnds = now.start - slip / gain;
    if (body.radius || body.inverseInertia == 0 || pressure <= 0) return;
    body.pressedAt = -heightOver(body, face) * drag / pressure;
    const auto [from, to] = baseOn(body, face);
    const double at = along.dot(now.position - face.velocity * now.start) + body.pressedAt;
    if (body.pressedAt < from || body.pressedAt > to || at < face.low || at > face.high)
        notKnown(body.scene->name, "it tips over");
}

void collide(FreeBody& b, FreeBody* a, const Vec2& velocityA, const Vec2& normal, const PairLaw& law) {
    const Vec2 along = tangentOf(normal);
    const double radiusA = a ? a->radius.value_or(0) : 0, radiusB = b.radius.value_or(0);
    const double massA = a ? a->inverseMass : 0, inertiaA = a ? a->inverseInertia : 0;
    const Vec2 apart = b.flight.velocity - (a ? a->flight.velocity : velocityA);
    const double rims = radiusB * b.flight.angularVelocity + (a ? radiusA * a->flight.angularVelocity : 0);
    const double push = -(1 + law.restitution) * apart.dot(normal) / (massA + b.inverseMass);
    const double give = massA + b.inverseMass + radiusA * radiusA * inertiaA + radiusB * radiusB * b.inverseInertia;
    const double slip = apart.dot(along) + rims - law.belts;
    const double rub = std::clamp(-slip / give, -law.friction * push, law.friction * push);
    const Vec2 impulse = push * normal + rub * along;
    b.flight.velocity += b.inverseMass * impulse;
    b.flight.angularVelocity += radiusB * b.inverseInertia * rub;
    if (!a) return;
    a->flight.velocity -= massA * impulse;
    a->flight.angularVelocity += radiusA * inertiaA * rub;
}

}  // namespace plumb::compare
