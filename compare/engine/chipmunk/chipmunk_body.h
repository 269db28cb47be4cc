// SPDX-License-Identifier: MIT
// How does a scene's body look in Chipmunk? Only for sources that are compiled against Chipmunk's headers.
#pragma once
#include <chipmunk/chipmunk.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/field/scene_fields.h>

namespace plumb::compare {

struct FreeChipmunk {
    void operator()(cpBody* body) const { cpBodyFree(body); }
    void operator()(cpShape* shape) const { cpShapeFree(shape); }
    void operator()(cpConstraint* constraint) const { cpConstraintFree(constraint); }
    void operator()(cpSpace* space) const { cpSpaceFree(space); }
};
/// Chipmunk frees nothing that was put into a space: each thing has an owner here.
template <class Thing>
using OwnedChipmunk = std::unique_ptr<Thing, FreeChipmunk>;

inline cpVect toChipmunk(const Vec2& v) {
    return cpv(v.x(), v.y());
}
inline Vec2 fromChipmunk(const cpVect& v) {
    return {v.x, v.y};
}

/// What Chipmunk's shapes have no room for. A shape's user data points to its own.
struct ChipmunkSurface {
    Material material;
    Filter filter;
};

/// The force on a body of the scene in this step of dt [s], asked when all bodies have moved in it.
using ChipmunkForces = std::function<FieldForce(std::size_t body, double dt)>;

/// Its cpBody's user data points to it: it stays where it is.
struct ChipmunkBody {
    OwnedChipmunk<cpBody> body{};
    std::vector<OwnedChipmunk<cpShape>> shapes{};
    std::vector<ChipmunkSurface> surfaces{};
    std::size_t index = 0;  ///< in the scene
    double gravityScale = 1, linearDamping = 0, angularDamping = 0;
    const ChipmunkForces* forces = nullptr;  ///< none without fields
    std::optional<cpVect> wanted{};          ///< a velocity to be given to it in the next step [m/s]
    bool enabled = true;
    bool canSleep = true;
};

/// Are the scene's filters as Chipmunk has them? It has 32 categories, and groups that never collide only.
bool hasChipmunkFilters(const Scene& scene);

/// filtered: by Chipmunk; else who is asked when a contact begins has to. A body that is not enabled is not
/// put into the space. Throws Unsupported, naming the body, when Chipmunk cannot have it as it is.
std::unique_ptr<ChipmunkBody> addChipmunkBody(cpSpace& space, const SceneBody& body, std::size_t index, bool filtered);

/// Out of the space, before it is freed. Its joints are out already.
void removeChipmunkBody(cpSpace& space, const ChipmunkBody& body);

BodyState stateOfChipmunk(const ChipmunkBody& body);

}  // namespace plumb::compare
