// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_body.h>

#include <fmt/format.h>

#include <array>

namespace plumb::compare {
namespace {

// Box2D 2.4's b2PolygonShape::Set takes corners nearer than this for one, and asserts when fewer than 3 are left.
constexpr double weldDistance = 0.5 * b2_linearSlop;

b2BodyType typeOf(BodyType type) {
    if (type == BodyType::Static) return b2_staticBody;
    if (type == BodyType::Kinematic) return b2_kinematicBody;
    return b2_dynamicBody;
}

b2Filter filterOf(const Filter& filter, const std::string& body) {
    constexpr std::uint64_t bits = 0xFFFF;
    if (filter.category & ~bits)
        throw Unsupported(
            fmt::format("body {}: filter category {:#x} does not fit Box2D 2.4's 16 bits", body, filter.category));
    b2Filter result;
    result.categoryBits = static_cast<uint16>(filter.category);
    // Bits of the mask beyond 16 can be dropped: no shape of the scene has such a category.
    result.maskBits = static_cast<uint16>(filter.mask & bits);
    return result;
}

void checkCorners(const Polygon& polygon, const std::string& body) {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((polygon.vertices[i] - polygon.vertices[j]).norm() <= weldDistance)
                throw Unsupported(
                    fmt::format("body {}: Box2D 2.4 welds polygon corners nearer than {:.4g} m", body, weldDistance));
}

void addShape(b2Body& body, b2FixtureDef& fixture, const Circle& circle, const std::string&) {
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(circle.radius);
    shape.m_p = toBox2d24(circle.center);
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

void addShape(b2Body& body, b2FixtureDef& fixture, const Polygon& polygon, const std::string& name) {
    checkCorners(polygon, name);
    const std::size_t count = polygon.vertices.size();
    b2Vec2 points[b2_maxPolygonVertices];
    for (std::size_t i = 0; i < count; ++i) points[i] = toBox2d24(polygon.vertices[i]);
    b2PolygonShape shape;
    shape.Set(points, static_cast<int32>(count));
    if (shape.m_count != static_cast<int32>(count))
        throw Unsupported(fmt::format("body {}: Box2D 2.4 takes polygon corners for being in line", name));
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

void addShape(b2Body& body, b2FixtureDef& fixture, const Segment& segment, const std::string&) {
    b2EdgeShape shape;
    shape.SetTwoSided(toBox2d24(segment.start), toBox2d24(segment.end));
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

void addShapes(b2Body& body, const SceneBody& sceneBody, float restitutionThreshold) {
    for (const ShapeDef& def : sceneBody.def.shapes) {
        b2FixtureDef fixture;
        fixture.density = static_cast<float>(def.material.density);
        fixture.friction = static_cast<float>(def.material.friction);
        fixture.restitution = static_cast<float>(def.material.restitution);
        fixture.restitutionThreshold = restitutionThreshold;
        fixture.filter = filterOf(def.filter, sceneBody.name);
        std::visit([&](const auto& shape) { addShape(body, fixture, shape, sceneBody.name); }, def.shape);
    }
}

}  // namespace

b2Vec2 toBox2d24(const Vec2& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

float restitutionThreshold24(const Scene& scene) {
    return bounces(scene) ? 0.0f : b2FixtureDef().restitutionThreshold;
}

b2Body* addBody24(b2World& world, const SceneBody& sceneBody, float restitutionThreshold) {
    const BodyDef& def = sceneBody.def;
    b2BodyDef bodyDef;
    bodyDef.type = typeOf(def.type);
    bodyDef.position = toBox2d24(def.position);
    bodyDef.angle = static_cast<float>(def.angle);
    bodyDef.gravityScale = static_cast<float>(def.gravityScale);
    bodyDef.linearDamping = static_cast<float>(def.linearDamping);
    bodyDef.angularDamping = static_cast<float>(def.angularDamping);
    bodyDef.fixedRotation = def.fixedRotation;
    bodyDef.allowSleep = def.canSleep;
    b2Body* body = world.CreateBody(&bodyDef);
    addShapes(*body, sceneBody, restitutionThreshold);
    if (def.mass && def.type == BodyType::Dynamic) {
        b2MassData mass;
        mass.mass = static_cast<float>(def.mass->mass);
        mass.center = toBox2d24(def.mass->center);
        // Box2D 2.4 wants the inertia about the body's origin.
        mass.I = static_cast<float>(def.mass->inertia + def.mass->mass * def.mass->center.squaredNorm());
        body->SetMassData(&mass);
    }
    // Last, because a velocity in the def would be the origin's, and change as shapes move the centre of mass.
    if (def.type != BodyType::Static) {
        body->SetLinearVelocity(toBox2d24(def.velocity));
        body->SetAngularVelocity(static_cast<float>(def.angularVelocity));
    }
    return body;
}

BodyState stateOf24(const b2Body& body) {
    const b2Vec2& position = body.GetPosition();
    const b2Vec2& velocity = body.GetLinearVelocity();
    return {{position.x, position.y}, body.GetAngle(), {velocity.x, velocity.y}, body.GetAngularVelocity()};
}

}  // namespace plumb::compare
