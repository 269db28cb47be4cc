// SPDX-License-Identifier: MIT
#include <compare/engine/chipmunk/chipmunk_contacts.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <compare/engine/chipmunk/chipmunk_body.h>
#include <compare/scene/shape_pair.h>

namespace plumb::compare {
namespace {

struct ShapePair {
    cpShape *a = nullptr, *b = nullptr;
};

ShapePair shapesOf(const cpArbiter* arbiter) {
    ShapePair pair;
    cpArbiterGetShapes(arbiter, &pair.a, &pair.b);
    return pair;
}

const ChipmunkSurface& chipmunkSurfaceOf(const cpShape* shape) {
    return *static_cast<const ChipmunkSurface*>(cpShapeGetUserData(shape));
}

std::size_t chipmunkIndexOf(const cpShape* shape) {
    return static_cast<const ChipmunkBody*>(cpBodyGetUserData(cpShapeGetBody(shape)))->index;
}

/// If it refuses a contact, the contact is not looked at again until the shapes have separated.
cpBool beginChipmunkContact(cpArbiter* arbiter, cpSpace*, cpDataPointer data) {
    auto& contacts = *static_cast<ChipmunkContacts*>(data);
    const auto [a, b] = shapesOf(arbiter);
    if (contacts.filters && !accepts(chipmunkSurfaceOf(a).filter, chipmunkSurfaceOf(b).filter)) return cpFalse;
    for (ChipmunkGate& gate : contacts.gates)
        for (const cpShape* shape : {a, b})
            if (cpShapeGetSensor(shape) && chipmunkIndexOf(shape) == gate.body) ++gate.count;
    return cpTrue;
}

cpBool mixChipmunkSurfaces(cpArbiter* arbiter, cpSpace*, cpDataPointer) {
    const auto [a, b] = shapesOf(arbiter);
    const Material& ofA = chipmunkSurfaceOf(a).material;
    const Material& ofB = chipmunkSurfaceOf(b).material;
    cpArbiterSetFriction(arbiter, mixed(ruleOf(ofA.frictionMix, ofB.frictionMix), ofA.friction, ofB.friction));
    cpArbiterSetRestitution(arbiter,
                            mixed(ruleOf(ofA.restitutionMix, ofB.restitutionMix), ofA.restitution, ofB.restitution));
    // The normal turned clockwise runs clockwise around A; seen from B, it runs clockwise around B. Chipmunk adds the
    // value that is set here to the velocity of B relative to A, and brings the sum to zero.
    const cpVect clockwise = cpvrperp(cpArbiterGetNormal(arbiter));
    cpArbiterSetSurfaceVelocity(arbiter, cpvmult(clockwise, -(ofA.surfaceSpeed + ofB.surfaceSpeed)));
    return cpTrue;
}

struct Pressed {
    const cpBody* other;
    double impulse = 0;
};

void addChipmunkImpulse(cpBody*, cpArbiter* arbiter, void* data) {
    auto& pressed = *static_cast<Pressed*>(data);
    cpBody *self = nullptr, *other = nullptr;
    cpArbiterGetBodies(arbiter, &self, &other);  // the first is the body whose arbiters are visited
    if (other == pressed.other)
        pressed.impulse += std::abs(cpvdot(cpArbiterTotalImpulse(arbiter), cpArbiterGetNormal(arbiter)));
}

}  // namespace

bool needsChipmunkMixing(const Scene& scene) {
    std::optional<double> restitution;
    for (const SceneBody& body : scene.bodies)
        for (const ShapeDef& shape : body.def.shapes) {
            const Material& material = shape.material;
            if (!mixesAsUsual(material) || material.surfaceSpeed != 0) return true;
            if (restitution.value_or(material.restitution) != material.restitution) return true;
            restitution = material.restitution;
        }
    return false;
}

void listenToChipmunk(cpSpace& space, const Scene& scene, ChipmunkContacts& contacts) {
    const bool begins = contacts.filters || !contacts.gates.empty(), mixes = needsChipmunkMixing(scene);
    if (!begins && !mixes) return;
    cpCollisionHandler& handler = *cpSpaceAddDefaultCollisionHandler(&space);
    handler.userData = &contacts;
    if (begins) handler.beginFunc = beginChipmunkContact;
    if (mixes) handler.preSolveFunc = mixChipmunkSurfaces;
}

double pressedInChipmunk(cpBody* a, const cpBody* b) {
    Pressed pressed{b};
    cpBodyEachArbiter(a, addChipmunkImpulse, &pressed);
    return pressed.impulse;
}

}  // namespace plumb::compare
