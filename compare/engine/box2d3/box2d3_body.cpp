// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_body.h>

#include <box2d/constants.h>
#include <fmt/format.h>

#include <cmath>

#include <compare/engine/single.h>

namespace plumb::compare {
namespace {

b2BodyType typeOf(BodyType type) {
    if (type == BodyType::Static) return b2_staticBody;
    if (type == BodyType::Kinematic) return b2_kinematicBody;
    return b2_dynamicBody;
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Circle& circle, const std::string&) {
    const b2Circle shape{toBox2d3(circle.center), toSingle(circle.radius)};
    b2CreateCircleShape(body, &def, &shape);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Polygon& polygon, const std::string& name) {
    const std::size_t count = polygon.vertices.size();
    b2Vec2 points[B2_MAX_POLYGON_VERTICES];
    for (std::size_t i = 0; i < count; ++i) points[i] = toBox2d3(polygon.vertices[i]);
    const b2Hull hull = b2ComputeHull(points, static_cast<int>(count));
    if (hull.count != static_cast<int>(count))
        throw Unsupported(fmt::format("body {}: Box2D 3 welds polygon corners nearer than {:.4g} m, or in line", name,
                                      4 * B2_LINEAR_SLOP));
    const b2Polygon shape = b2MakePolygon(&hull, 0);
    b2CreatePolygonShape(body, &def, &shape);
}

void addShape(b2BodyId body, const b2ShapeDef& def, const Segment& segment, const std::string& name) {
    if ((segment.end - segment.start).norm() <= static_cast<double>(B2_LINEAR_SLOP))
        throw Unsupported(fmt::format("body {}: Box2D 3 has no segment shorter than {} m", name, B2_LINEAR_SLOP));
    const b2Segment shape{toBox2d3(segment.start), toBox2d3(segment.end)};
    b2CreateSegmentShape(body, &def, &shape);
}

void addShapes(b2BodyId body, const SceneBody& sceneBody) {
    for (const ShapeDef& shape : sceneBody.def.shapes) {
        b2ShapeDef def = b2DefaultShapeDef();
        def.density = toSingle(shape.material.density);
        def.material.friction = toSingle(shape.material.friction);
        def.material.restitution = toSingle(shape.material.restitution);
        def.filter.categoryBits = shape.filter.category;
        def.filter.maskBits = shape.filter.mask;
        std::visit([&](const auto& s) { addShape(body, def, s, sceneBody.name); }, shape.shape);
    }
}

b2BodyDef definition(const BodyDef& def) {
    b2BodyDef result = b2DefaultBodyDef();
    result.type = typeOf(def.type);
    result.position = b2ToPos(toBox2d3(def.position));
    // Not b2MakeRot: it only comes near sine and cosine, and the scene's start should not carry that error.
    result.rotation = {static_cast<float>(std::cos(def.angle)), static_cast<float>(std::sin(def.angle))};
    result.gravityScale = toSingle(def.gravityScale);
    result.linearDamping = toSingle(def.linearDamping);
    result.angularDamping = toSingle(def.angularDamping);
    result.motionLocks.angularZ = def.fixedRotation;
    result.enableSleep = def.canSleep;
    return result;
}

}  // namespace

b2Vec2 toBox2d3(const Vec2& v) {
    return {toSingle(v.x()), toSingle(v.y())};
}

b2BodyId addBody3(b2WorldId world, const SceneBody& sceneBody) {
    const BodyDef& def = sceneBody.def;
    const b2BodyDef bodyDef = definition(def);
    const b2BodyId body = b2CreateBody(world, &bodyDef);
    addShapes(body, sceneBody);
    if (def.mass && def.type == BodyType::Dynamic) {
        const b2MassData mass{toSingle(def.mass->mass), toBox2d3(def.mass->center), toSingle(def.mass->inertia)};
        b2Body_SetMassData(body, mass);
    }
    // Last, because a velocity in the def would be the origin's, and change as shapes move the centre of mass.
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
    // Not b2Rot_GetAngle: it only comes near the arc tangent, and the engine should not be blamed for that.
    const double angle = std::atan2(static_cast<double>(rotation.s), static_cast<double>(rotation.c));
    return {{position.x, position.y}, angle, {velocity.x, velocity.y}, b2Body_GetAngularVelocity(body)};
}

}  // namespace plumb::compare
