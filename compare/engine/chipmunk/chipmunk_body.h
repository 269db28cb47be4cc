// SPDX-License-Identifier: MIT
// How is a scene's body made in Chipmunk? Only for sources that are compiled against Chipmunk's headers.
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
/// Chipmunk does not free what was put into a space, so each object has an owner here.
template <class Thing>
using OwnedChipmunk = std::unique_ptr<Thing, FreeChipmunk>;

inline cpVect toChipmunk(const Vec2& v) {
    return cpv(v.x(), v.y());
}
inline Vec2 fromChipmunk(const cpVect& v) {
    return {v.x, v.y};
}

/// Values that Chipmunk's shapes cannot store. A shape's user data points to its surface.
struct ChipmunkSurface {
    Material material;
    Filter filter;
};

/// The force on a body of the scene in this step of dt [s]. It is called after all bodies have moved in the step.
using ChipmunkForces = std::function<FieldForce(std::size_t body, double dt)>;

/// The user data of its cpBody points to it, so it must not move in memory.
struct ChipmunkBody {
    OwnedChipmunk<cpBody> body{};
    std::vector<OwnedChipmunk<cpShape>> shapes{};
    std::vector<ChipmunkSurface> surfaces{};
    std::size_t index = 0;  ///< in the scene
    double gravityScale = 1, linearDamping = 0, angularDamping = 0;
    const ChipmunkForces* forces = nullptr;  ///< null if there are no fields
    std::optional<cpVect> wanted{};          ///< the velocity that it gets in the next step [m/s]
    bool enabled = true;
    bool canSleep = true;
};

/// Can Chipmunk express the scene's filters? It has 32 categories, and only groups that never collide.
bool hasChipmunkFilters(const Scene& scene);

/// filtered: Chipmunk's own filters are used; otherwise, the handler that is called when a contact begins filters. A
/// body that is not enabled is not put into the space. Throws Unsupported, which names the body, if Chipmunk cannot
/// have it as it is.
std::unique_ptr<ChipmunkBody> addChipmunkBody(cpSpace& space, const SceneBody& body, std::size_t index, bool filtered);

/// Takes the body out of the space, before it is freed. Its joints must be taken out first.
void removeChipmunkBody(cpSpace& space, const ChipmunkBody& body);

BodyState stateOfChipmunk(const ChipmunkBody& body);

}  // namespace plumb::compare
