// SPDX-License-Identifier: MIT
#include <compare/engine/chipmunk/chipmunk_body.h>

#include <chipmunk/chipmunk_structs.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <compare/engine/outline.h>

namespace plumb::compare {
namespace {

bool isChipmunkFilter(const Filter& filter) {
    return filter.category <= std::numeric_limits<cpBitmask>::max() && filter.group <= 0;
}

/// The mask's bits beyond 32 can be dropped: no shape of the scene has such a category.
cpShapeFilter chipmunkFilterOf(const Filter& filter) {
    const auto group = static_cast<cpGroup>(-static_cast<std::int64_t>(filter.group));
    return cpShapeFilterNew(group, static_cast<cpBitmask>(filter.category), static_cast<cpBitmask>(filter.mask));
}

/// Applies a body's own gravity and damping, and the forces of fields. Chipmunk moves bodies first. A force computed
/// before that would make the step an explicit Euler step, in which orbits grow without limit. Damping uses Chipmunk's
/// own rule, which Chipmunk only has for a whole space. It is applied before gravity, so the full weight of a damped
/// body is borne.
void updateChipmunkVelocity(cpBody* body, cpVect gravity, cpFloat, cpFloat dt) {
    auto& its = *static_cast<ChipmunkBody*>(body->userData);
    // The members are set directly, because the setters would wake the body.
    if (its.forces) {
        const FieldForce force = (*its.forces)(its.index, dt);
        body->f = cpvadd(body->f, toChipmunk(force.force));
        body->t += force.torque;
    }
    body->v = std::exchange(its.wanted, std::nullopt).value_or(body->v);
    const double left = std::exp(-its.linearDamping * dt), spin = body->w;
    cpBodyUpdateVelocity(body, cpvmult(gravity, its.gravityScale), left, dt);
    body->w += spin * (std::exp(-its.angularDamping * dt) - left);
}

class ChipmunkShapes {
public:
    ChipmunkShapes(ChipmunkBody& body, const std::string& name) : body_(body), name_(name) {}

    void operator()(const Circle& circle) const {
        add(cpCircleShapeNew(body_.body.get(), circle.radius, toChipmunk(circle.center)));
    }
    void operator()(const Capsule& capsule) const {
        add(cpSegmentShapeNew(body_.body.get(), toChipmunk(capsule.start), toChipmunk(capsule.end), capsule.radius));
    }
    void operator()(const Polygon& polygon) const {
        std::vector<cpVect> corners;
        for (const Vec2& corner : polygon.vertices) corners.push_back(toChipmunk(corner));
        // Chipmunk's own boxes start at the lower right corner. If boxes start at the lower left, a stack of ten leans
        // and falls.
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        add(cpPolyShapeNewRaw(body_.body.get(), static_cast<int>(corners.size()), corners.data(), polygon.radius));
    }
    /// An end without a neighbour can be hit from all sides. In Chipmunk, such an end is its own neighbour.
    void operator()(const Segment& segment) const {
        cpShape* shape = cpSegmentShapeNew(body_.body.get(), toChipmunk(segment.start), toChipmunk(segment.end), 0);
        cpSegmentShapeSetNeighbors(shape, toChipmunk(segment.before.value_or(segment.start)),
                                   toChipmunk(segment.after.value_or(segment.end)));
        add(shape);
    }
    void operator()(const Chain& chain) const {
        const std::size_t count = chain.points.size();
        const std::size_t segments = chain.closed ? count : count - 1;
        for (std::size_t i = 0; i < segments; ++i) {
            Segment segment{chain.points[i], chain.points[(i + 1) % count]};
            if (chain.closed || i > 0) segment.before = chain.points[(i + count - 1) % count];
            if (chain.closed || i + 2 < count) segment.after = chain.points[(i + 2) % count];
            (*this)(segment);
        }
    }
    /// One polygon for each tile, because Chipmunk has no tile map.
    void operator()(const TileMap& map) const {
        for (const Polygon& tile : tilePolygons(map, name_)) (*this)(tile);
    }

private:
    void add(cpShape* shape) const { body_.shapes.emplace_back(shape); }

    ChipmunkBody& body_;
    const std::string& name_;
};

void checkChipmunkShape(const ShapeDef& def, const std::string& body) {
    if (def.material.rollingResistance > 0)
        throw Unsupported(fmt::format("body {}: Chipmunk has no rolling resistance", body));
    if (def.oneWay)
        throw Unsupported(fmt::format("body {}: Chipmunk leaves one-way shapes to its user's own code", body));
}

/// Chipmunk multiplies the coefficients of a pair. The product of square roots is the geometric mean. For friction,
/// this is the rule in most scenes; for restitution, it gives the value that all shapes of a scene share.
void setSurface(cpShape* shape, const ShapeDef& def, ChipmunkSurface& surface, bool filtered) {
    cpShapeSetFriction(shape, std::sqrt(def.material.friction));
    cpShapeSetElasticity(shape, std::sqrt(def.material.restitution));
    cpShapeSetSensor(shape, static_cast<cpBool>(def.sensor));
    if (filtered) cpShapeSetFilter(shape, chipmunkFilterOf(def.filter));
    cpShapeSetUserData(shape, &surface);
}

void addChipmunkShapes(cpSpace& space, ChipmunkBody& made, const SceneBody& sceneBody, bool filtered) {
    made.surfaces.reserve(sceneBody.def.shapes.size());  // shapes point into it, so it must not grow
    for (const ShapeDef& def : sceneBody.def.shapes) {
        checkChipmunkShape(def, sceneBody.name);
        const std::size_t before = made.shapes.size();
        std::visit(ChipmunkShapes(made, sceneBody.name), def.shape);
        ChipmunkSurface& surface = made.surfaces.emplace_back(ChipmunkSurface{def.material, def.filter});
        for (const OwnedChipmunk<cpShape>& shape : std::span(made.shapes).subspan(before))
            setSurface(shape.get(), def, surface, filtered);
    }
    if (!made.enabled) return;
    cpSpaceAddBody(&space, made.body.get());
    for (const OwnedChipmunk<cpShape>& shape : made.shapes) cpSpaceAddShape(&space, shape.get());
}

/// The body gets its mass, its inertia about the centre of mass, and the centre of mass; so its shapes have no mass.
cpBody* newChipmunkBody(const BodyDef& def) {
    if (def.type == BodyType::Static) return cpBodyNewStatic();
    if (def.type == BodyType::Kinematic) return cpBodyNewKinematic();
    const Mass mass = massOf(def);
    constexpr double never = std::numeric_limits<double>::infinity();
    cpBody* body = cpBodyNew(mass.mass, def.fixedRotation ? never : mass.inertia);
    cpBodySetCenterOfGravity(body, toChipmunk(mass.center));
    cpBodySetVelocityUpdateFunc(body, updateChipmunkVelocity);
    return body;
}

}  // namespace

bool hasChipmunkFilters(const Scene& scene) {
    return std::ranges::all_of(scene.bodies, [](const SceneBody& body) {
        return std::ranges::all_of(body.def.shapes,
                                   [](const ShapeDef& shape) { return isChipmunkFilter(shape.filter); });
    });
}

std::unique_ptr<ChipmunkBody> addChipmunkBody(cpSpace& space, const SceneBody& sceneBody, std::size_t index,
                                              bool filtered) {
    const BodyDef& def = sceneBody.def;
    if (def.lockX || def.lockY)
        throw Unsupported(fmt::format("body {}: Chipmunk has no lock along an axis", sceneBody.name));
    auto made = std::make_unique<ChipmunkBody>();
    made->index = index;
    made->gravityScale = def.gravityScale;
    made->linearDamping = def.linearDamping;
    made->angularDamping = def.angularDamping;
    made->enabled = def.enabled;
    made->canSleep = def.canSleep;
    made->body.reset(newChipmunkBody(def));
    cpBody* body = made->body.get();
    cpBodySetUserData(body, made.get());
    // The angle is set first, because the place of the centre of mass depends on it.
    cpBodySetAngle(body, def.angle);
    cpBodySetPosition(body, toChipmunk(def.position));
    if (def.type != BodyType::Static) {
        cpBodySetVelocity(body, toChipmunk(def.velocity));
        cpBodySetAngularVelocity(body, def.fixedRotation ? 0 : def.angularVelocity);
    }
    addChipmunkShapes(space, *made, sceneBody, filtered);
    return made;
}

void removeChipmunkBody(cpSpace& space, const ChipmunkBody& body) {
    if (!body.enabled) return;
    for (const OwnedChipmunk<cpShape>& shape : body.shapes) cpSpaceRemoveShape(&space, shape.get());
    cpSpaceRemoveBody(&space, body.body.get());
}

BodyState stateOfChipmunk(const ChipmunkBody& body) {
    const cpBody* its = body.body.get();
    return {fromChipmunk(cpBodyGetPosition(its)), cpBodyGetAngle(its), fromChipmunk(cpBodyGetVelocity(its)),
            cpBodyGetAngularVelocity(its)};
}

}  // namespace plumb::compare
