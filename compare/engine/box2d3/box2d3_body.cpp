// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_body.h>

#include <box2d/constants.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <compare/engine/outline.h>
#include <compare/engine/single.h>
#include <compare/scene/shape_pair.h>

namespace plumb::compare {
namespace {

constexpr std::uint64_t mixCount = 5;  // number of rules in Mix

/// A material's two mixing rules as one number, which Box2D 3 stores; 0 for Box2D's own rules.
std::uint64_t mixesId(const Material& material) {
    if (mixesAsUsual(material)) return 0;
    return 1 + static_cast<std::uint64_t>(material.frictionMix) +
           mixCount * static_cast<std::uint64_t>(material.restitutionMix);
}

struct Mixes {
    Mix friction, restitution;
};

Mixes mixesOf(std::uint64_t id) {
    if (id == 0) return {Mix::GeometricMean, Mix::Maximum};
    return {static_cast<Mix>((id - 1) % mixCount), static_cast<Mix>((id - 1) / mixCount)};
}

b2BodyType typeOf(BodyType type) {
    if (type == BodyType::Static) return b2_staticBody;
    if (type == BodyType::Kinematic) return b2_kinematicBody;
    return b2_dynamicBody;
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Circle& circle, const std::string&) {
    const b2Circle shape{toBox2d3(circle.center), toSingle(circle.radius)};
    b2CreateCircleShape(body, &def, &shape);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Capsule& capsule, const std::string& name) {
    if ((capsule.end - capsule.start).norm() <= static_cast<double>(B2_LINEAR_SLOP))
        throw Unsupported(fmt::format("body {}: Box2D 3 has no capsule shorter than {} m", name, B2_LINEAR_SLOP));
    const b2Capsule shape{toBox2d3(capsule.start), toBox2d3(capsule.end), toSingle(capsule.radius)};
    b2CreateCapsuleShape(body, &def, &shape);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Polygon& polygon, const std::string& name) {
    const std::size_t count = polygon.vertices.size();
    if (count > B2_MAX_POLYGON_VERTICES)
        throw Unsupported(
            fmt::format("body {}: Box2D 3 has no polygon of more than {} corners", name, B2_MAX_POLYGON_VERTICES));
    b2Vec2 points[B2_MAX_POLYGON_VERTICES];
    for (std::size_t i = 0; i < count; ++i) points[i] = toBox2d3(polygon.vertices[i]);
    const b2Hull hull = b2ComputeHull(points, static_cast<int>(count));
    if (hull.count != static_cast<int>(count))
        throw Unsupported(fmt::format("body {}: Box2D 3 welds polygon corners nearer than {:.4g} m, or in line", name,
                                      4 * B2_LINEAR_SLOP));
    const b2Polygon shape = b2MakePolygon(&hull, toSingle(polygon.radius));
    b2CreatePolygonShape(body, &def, &shape);
}

/// The first and the last point of an open line are the ghost points that Box2D 3 needs at its ends.
void addChain(b2BodyId body, const b2ShapeDef& def, const std::vector<Vec2>& line, bool closed,
              const std::string& name) {
    std::vector<b2Vec2> points;
    for (const Vec2& point : line) points.push_back(toBox2d3(point));
    for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i)
        if (b2Distance(points[i], points[(i + points.size() - 1) % points.size()]) <= B2_LINEAR_SLOP)
            throw Unsupported(
                fmt::format("body {}: Box2D 3 has no chain with a segment of {} m or less", name, B2_LINEAR_SLOP));
    b2ChainDef chainDef = b2DefaultChainDef();
    chainDef.points = points.data();
    chainDef.count = static_cast<int>(points.size());
    chainDef.isLoop = closed;
    chainDef.materials = &def.material;
    chainDef.materialCount = 1;
    chainDef.filter = def.filter;
    chainDef.enableSensorEvents = def.enableSensorEvents;
    b2CreateChain(body, &chainDef);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Segment& segment, const std::string& name) {
    if (hasNeighbour(segment)) return addChain(body, def, withGhosts(segment), false, name);
    if ((segment.end - segment.start).norm() <= static_cast<double>(B2_LINEAR_SLOP))
        throw Unsupported(fmt::format("body {}: Box2D 3 has no segment shorter than {} m", name, B2_LINEAR_SLOP));
    const b2Segment shape{toBox2d3(segment.start), toBox2d3(segment.end)};
    b2CreateSegmentShape(body, &def, &shape);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Chain& chain, const std::string& name) {
    if (chain.closed && chain.points.size() < 4)
        throw Unsupported(fmt::format("body {}: Box2D 3 has no ring of fewer than 4 points", name));
    addChain(body, def, chain.closed ? chain.points : withGhosts(chain), chain.closed, name);
}

/// One polygon for each tile, because Box2D has no tile map.
void addShape(b2BodyId body, const b2ShapeDef& def, const TileMap& map, const std::string& name) {
    for (const Polygon& tile : tilePolygons(map, name)) addShape(body, def, tile, name);
}

b2SurfaceMaterial surfaceOf(const Material& material) {
    b2SurfaceMaterial result = b2DefaultSurfaceMaterial();
    result.friction = toSingle(material.friction);
    result.restitution = toSingle(material.restitution);
    result.rollingResistance = toSingle(material.rollingResistance);
    // Box2D's tangent is the normal turned clockwise: so a positive speed runs clockwise around either body.
    result.tangentSpeed = toSingle(material.surfaceSpeed);
    result.userMaterialId = mixesId(material);
    return result;
}

void addShapes(b2BodyId body, const SceneBody& sceneBody, bool senses) {
    for (const ShapeDef& shape : sceneBody.def.shapes) {
        if (shape.oneWay)
            throw Unsupported(
                fmt::format("body {}: Box2D 3 leaves one-way shapes to its user's own code", sceneBody.name));
        b2ShapeDef def = b2DefaultShapeDef();
        def.isSensor = shape.sensor;
        def.enableSensorEvents = senses;
        def.density = toSingle(shape.material.density);
        def.material = surfaceOf(shape.material);
        def.filter.categoryBits = shape.filter.category;
        def.filter.maskBits = shape.filter.mask;
        def.filter.groupIndex = shape.filter.group;
        std::visit([&](const auto& s) { addShape(body, def, s, sceneBody.name); }, shape.shape);
    }
}

b2BodyDef definition(const BodyDef& def) {
    b2BodyDef result = b2DefaultBodyDef();
    result.type = typeOf(def.type);
    result.position = b2ToPos(toBox2d3(def.position));
    // b2MakeRot only approximates sine and cosine. The scene's start should not have that error.
    result.rotation = {static_cast<float>(std::cos(def.angle)), static_cast<float>(std::sin(def.angle))};
    result.gravityScale = toSingle(def.gravityScale);
    result.linearDamping = toSingle(def.linearDamping);
    result.angularDamping = toSingle(def.angularDamping);
    result.motionLocks = {.linearX = def.lockX, .linearY = def.lockY, .angularZ = def.fixedRotation};
    result.isEnabled = def.enabled;
    result.enableSleep = def.canSleep;
    result.isAwake = def.awake;
    return result;
}

}  // namespace

b2Vec2 toBox2d3(const Vec2& v) {
    return {toSingle(v.x()), toSingle(v.y())};
}

float mixedFriction3(float a, std::uint64_t materialA, float b, std::uint64_t materialB) {
    return mixed(ruleOf(mixesOf(materialA).friction, mixesOf(materialB).friction), a, b);
}

float mixedRestitution3(float a, std::uint64_t materialA, float b, std::uint64_t materialB) {
    return mixed(ruleOf(mixesOf(materialA).restitution, mixesOf(materialB).restitution), a, b);
}

b2BodyId addBody3(b2WorldId world, const SceneBody& sceneBody, bool senses) {
    const BodyDef& def = sceneBody.def;
    const b2BodyDef bodyDef = definition(def);
    const b2BodyId body = b2CreateBody(world, &bodyDef);
    addShapes(body, sceneBody, senses);
    // Box2D 3 weighs a rounded polygon as if its corners were sharp.
    const auto rounded = [](const ShapeDef& shape) { return isRounded(shape.shape); };
    if (def.type == BodyType::Dynamic && (def.mass || std::ranges::any_of(def.shapes, rounded))) {
        const Mass mass = massOf(def);
        b2Body_SetMassData(body, {toSingle(mass.mass), toBox2d3(mass.center), toSingle(mass.inertia)});
    }
    // This comes last: a velocity in the def would be the origin's, and it would change when shapes move the centre of
    // mass.
    if (def.type != BodyType::Static) {
        b2Body_SetLinearVelocity(body, toBox2d3(def.velocity));
        b2Body_SetAngularVelocity(body, toSingle(def.angularVelocity));
    }
    return body;
}

BodyState stateOf3(b2BodyId body) {
    const b2Pos position = b2Body_GetPosition(body);
    const b2Vec2 velocity = b2Body_GetLinearVelocity(body);
    const b2Rot rotation = b2Body_GetRotation(body);
    // b2Rot_GetAngle only approximates the arc tangent. That error should not count as the engine's.
    const double angle = std::atan2(static_cast<double>(rotation.s), static_cast<double>(rotation.c));
    return {{position.x, position.y}, angle, {velocity.x, velocity.y}, b2Body_GetAngularVelocity(body)};
}

}  // namespace plumb::compare
