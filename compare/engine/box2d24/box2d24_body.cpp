// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_body.h>

#include <fmt/format.h>

#include <compare/engine/single.h>

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

// Box2D 2.4 asserts that an area is more than this, and so ends the program.
constexpr double leastArea = 2 * b2_epsilon;  // [m^2]

void checkCorners(const Polygon& polygon, const std::string& body) {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((polygon.vertices[i] - polygon.vertices[j]).norm() <= weldDistance)
                throw Unsupported(
                    fmt::format("body {}: Box2D 2.4 welds polygon corners nearer than {:.4g} m", body, weldDistance));
    if (massOf(polygon, 1).mass <= leastArea)
        throw Unsupported(fmt::format("body {}: Box2D 2.4 has no polygon smaller than {:.2g} m^2", body, leastArea));
}

// Box2D 2.4 sums inertia about the body's origin, takes off the centre's part, and asserts that something is left.
void checkInertia(const BodyDef& def, const std::string& body) {
    constexpr double lost = 1e-5;  // some roundings of single precision, 6e-8 each
    if (def.type != BodyType::Dynamic) return;
    const Mass mass = massOf(def);
    if (mass.inertia <= lost * mass.mass * mass.center.squaredNorm())
        throw Unsupported(
            fmt::format("body {}: its inertia is lost in single precision, so far is its centre of mass "
                        "from its origin",
                        body));
}

void addShape(b2Body& body, b2FixtureDef& fixture, const Circle& circle, const std::string&) {
    b2CircleShape shape;
    shape.m_radius = toSingle(circle.radius);
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
        fixture.density = toSingle(def.material.density);
        fixture.friction = toSingle(def.material.friction);
        fixture.restitution = toSingle(def.material.restitution);
        fixture.restitutionThreshold = restitutionThreshold;
        fixture.filter = filterOf(def.filter, sceneBody.name);
        std::visit([&](const auto& shape) { addShape(body, fixture, shape, sceneBody.name); }, def.shape);
    }
}

}  // namespace

b2Vec2 toBox2d24(const Vec2& v) {
    return {toSingle(v.x()), toSingle(v.y())};
}

float restitutionThreshold24(const Scene& scene) {
    return bounces(scene) ? 0.0f : b2FixtureDef().restitutionThreshold;
}

b2Body* addBody24(b2World& world, const SceneBody& sceneBody, float restitutionThreshold) {
    const BodyDef& def = sceneBody.def;
    checkInertia(def, sceneBody.name);
    b2BodyDef bodyDef;
    bodyDef.type = typeOf(def.type);
    bodyDef.position = toBox2d24(def.position);
    bodyDef.angle = toSingle(def.angle);
    bodyDef.gravityScale = toSingle(def.gravityScale);
    bodyDef.linearDamping = toSingle(def.linearDamping);
    bodyDef.angularDamping = toSingle(def.angularDamping);
    bodyDef.fixedRotation = def.fixedRotation;
    bodyDef.allowSleep = def.canSleep;
    b2Body* body = world.CreateBody(&bodyDef);
    addShapes(*body, sceneBody, restitutionThreshold);
    if (def.mass && def.type == BodyType::Dynamic) {
        b2MassData mass;
        mass.mass = toSingle(def.mass->mass);
        mass.center = toBox2d24(def.mass->center);
        // Box2D 2.4 wants the inertia about the body's origin.
        mass.I = toSingle(def.mass->inertia + def.mass->mass * def.mass->center.squaredNorm());
        body->SetMassData(&mass);
    }
    // Last, because a velocity in the def would be the origin's, and change as shapes move the centre of mass.
    if (def.type != BodyType::Static) {
        body->SetLinearVelocity(toBox2d24(def.velocity));
        body->SetAngularVelocity(toSingle(def.angularVelocity));
    }
    return body;
}

BodyState stateOf24(const b2Body& body) {
    const b2Vec2& position = body.GetPosition();
    const b2Vec2& velocity = body.GetLinearVelocity();
    return {{position.x, position.y}, body.GetAngle(), {velocity.x, velocity.y}, body.GetAngularVelocity()};
}

}  // namespace plumb::compare
