// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_body.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include <compare/engine/outline.h>
#include <compare/engine/single.h>
#include <compare/scene/shape_pair.h>

namespace plumb::compare {
namespace {

// Box2D 2.4's b2PolygonShape::Set merges corners that are nearer than this, and asserts if fewer than 3 are left.
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
    result.groupIndex = static_cast<int16>(filter.group);
    if (result.groupIndex != filter.group)
        throw Unsupported(fmt::format("body {}: filter group {} does not fit Box2D 2.4's 16 bits", body, filter.group));
    return result;
}

// Box2D 2.4 asserts that an area is larger than this, and so ends the program if it is not.
constexpr double leastArea = 2 * b2_epsilon;  // [m^2]

void checkCorners(const Polygon& polygon, const std::string& body) {
    if (polygon.vertices.size() > b2_maxPolygonVertices)
        throw Unsupported(
            fmt::format("body {}: Box2D 2.4 has no polygon of more than {} corners", body, b2_maxPolygonVertices));
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((polygon.vertices[i] - polygon.vertices[j]).norm() <= weldDistance)
                throw Unsupported(
                    fmt::format("body {}: Box2D 2.4 welds polygon corners nearer than {:.4g} m", body, weldDistance));
    if (massOf(Polygon{polygon.vertices}, 1).mass <= leastArea)
        throw Unsupported(fmt::format("body {}: Box2D 2.4 has no polygon smaller than {:.2g} m^2", body, leastArea));
}

// Box2D 2.4 sums the inertia about the body's origin, subtracts the part of the centre of mass, and asserts that the
// rest is positive.
void checkInertia(const BodyDef& def, const std::string& body) {
    constexpr double lost = 1e-5;  // several roundings in single precision, 6e-8 each
    if (def.type != BodyType::Dynamic) return;
    const Mass mass = massOf(def);
    if (mass.inertia <= lost * mass.mass * mass.center.squaredNorm())
        throw Unsupported(
            fmt::format("body {}: its inertia is lost in single precision, so far is its centre of mass "
                        "from its origin",
                        body));
}

void addShape(b2Body& body, b2FixtureDef fixture, const Circle& circle, const std::string&) {
    b2CircleShape shape;
    shape.m_radius = toSingle(circle.radius);
    shape.m_p = toBox2d24(circle.center);
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

/// The radius of a rounded polygon becomes its skin. Box2D 2.4 keeps the skin around edges, and partly around corners.
/// The skin has no mass.
void addShape(b2Body& body, b2FixtureDef fixture, const Polygon& polygon, const std::string& name) {
    checkCorners(polygon, name);
    const std::size_t count = polygon.vertices.size();
    b2Vec2 points[b2_maxPolygonVertices];
    for (std::size_t i = 0; i < count; ++i) points[i] = toBox2d24(polygon.vertices[i]);
    b2PolygonShape shape;
    shape.Set(points, static_cast<int32>(count));
    if (shape.m_count != static_cast<int32>(count))
        throw Unsupported(fmt::format("body {}: Box2D 2.4 takes polygon corners for being in line", name));
    shape.m_radius = std::max(shape.m_radius, toSingle(polygon.radius));
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

/// Two discs with a box between them. With its skin, the box is as thick as the discs.
void addShape(b2Body& body, b2FixtureDef fixture, const Capsule& capsule, const std::string& name) {
    constexpr double skin = b2_polygonRadius;
    if (toSingle(capsule.radius) <= 2 * b2_polygonRadius)
        throw Unsupported(fmt::format("body {}: of a capsule as thin as {} m Box2D 2.4's skin of {} m would be half",
                                      name, capsule.radius, skin));
    fixture.density = 0;  // the parts overlap: the body gets the capsule's mass
    addShape(body, fixture, Circle{capsule.radius, capsule.start}, name);
    addShape(body, fixture, Circle{capsule.radius, capsule.end}, name);
    addShape(body, fixture, axisBox(capsule, capsule.radius - skin), name);
}

void addShape(b2Body& body, b2FixtureDef fixture, const Segment& segment, const std::string&) {
    b2EdgeShape shape;
    if (hasNeighbour(segment)) {
        const std::vector<Vec2> points = withGhosts(segment);
        shape.SetOneSided(toBox2d24(points[0]), toBox2d24(points[1]), toBox2d24(points[2]), toBox2d24(points[3]));
    } else {
        shape.SetTwoSided(toBox2d24(segment.start), toBox2d24(segment.end));
    }
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

void addShape(b2Body& body, b2FixtureDef fixture, const Chain& chain, const std::string& name) {
    const std::vector<Vec2> wanted = chain.closed ? chain.points : withGhosts(chain);
    std::vector<b2Vec2> points;
    for (const Vec2& point : wanted) points.push_back(toBox2d24(point));
    for (std::size_t i = chain.closed ? 0 : 1; i < points.size(); ++i)
        if (b2Distance(points[i], points[(i + points.size() - 1) % points.size()]) <= b2_linearSlop)
            throw Unsupported(
                fmt::format("body {}: Box2D 2.4 has no chain with a segment of {} m or less", name, b2_linearSlop));
    const auto count = static_cast<int32>(points.size());
    b2ChainShape shape;
    if (chain.closed)
        shape.CreateLoop(points.data(), count);
    else
        shape.CreateChain(&points[1], count - 2, points.front(), points.back());
    fixture.shape = &shape;
    body.CreateFixture(&fixture);
}

/// One polygon for each tile, because Box2D has no tile map.
void addShape(b2Body& body, b2FixtureDef fixture, const TileMap& map, const std::string& name) {
    for (const Polygon& tile : tilePolygons(map, name)) addShape(body, fixture, tile, name);
}

/// The material that is needed when a contact begins; null if Box2D 2.4 can mix the coefficients by itself.
const Material* keep(const Material& material, Surfaces24& surfaces) {
    if (mixesAsUsual(material) && material.surfaceSpeed == 0) return nullptr;
    return &surfaces.emplace_back(material);
}

void addShapes(b2Body& body, const SceneBody& sceneBody, float restitutionThreshold, Surfaces24& surfaces) {
    for (const ShapeDef& def : sceneBody.def.shapes) {
        const Material& material = def.material;
        if (material.rollingResistance > 0)
            throw Unsupported(fmt::format("body {}: Box2D 2.4 has no rolling resistance", sceneBody.name));
        if (def.oneWay)
            throw Unsupported(
                fmt::format("body {}: Box2D 2.4 leaves one-way shapes to its user's own code", sceneBody.name));
        b2FixtureDef fixture;
        fixture.isSensor = def.sensor;
        fixture.density = toSingle(material.density);
        fixture.friction = toSingle(material.friction);
        fixture.restitution = toSingle(material.restitution);
        fixture.restitutionThreshold = restitutionThreshold;
        fixture.filter = filterOf(def.filter, sceneBody.name);
        fixture.userData.pointer = reinterpret_cast<std::uintptr_t>(keep(material, surfaces));
        std::visit([&](const auto& shape) { addShape(body, fixture, shape, sceneBody.name); }, def.shape);
    }
}

const Material* surfaceOf(b2Fixture& fixture) {
    return reinterpret_cast<const Material*>(fixture.GetUserData().pointer);
}

/// Does the body have a given mass, or a shape that has another form and another mass in Box2D 2.4?
bool needsMass(const BodyDef& def) {
    return def.mass || std::ranges::any_of(def.shapes, [](const ShapeDef& shape) {
               return std::holds_alternative<Capsule>(shape.shape) || isRounded(shape.shape);
           });
}

void setMass(b2Body& body, const Mass& mass) {
    b2MassData data;
    data.mass = toSingle(mass.mass);
    data.center = toBox2d24(mass.center);
    // Box2D 2.4 expects the inertia about the body's origin.
    data.I = toSingle(mass.inertia + mass.mass * mass.center.squaredNorm());
    body.SetMassData(&data);
}

}  // namespace

b2Vec2 toBox2d24(const Vec2& v) {
    return {toSingle(v.x()), toSingle(v.y())};
}

float restitutionThreshold24(const Scene& scene) {
    return bounces(scene) ? 0.0f : b2FixtureDef().restitutionThreshold;
}

b2Body* addBody24(b2World& world, const SceneBody& sceneBody, float restitutionThreshold, Surfaces24& surfaces) {
    const BodyDef& def = sceneBody.def;
    checkInertia(def, sceneBody.name);
    if (def.lockX || def.lockY)
        throw Unsupported(fmt::format("body {}: Box2D 2.4 has no lock along an axis", sceneBody.name));
    b2BodyDef bodyDef;
    bodyDef.enabled = def.enabled;
    bodyDef.type = typeOf(def.type);
    bodyDef.position = toBox2d24(def.position);
    bodyDef.angle = toSingle(def.angle);
    bodyDef.gravityScale = toSingle(def.gravityScale);
    bodyDef.linearDamping = toSingle(def.linearDamping);
    bodyDef.angularDamping = toSingle(def.angularDamping);
    bodyDef.fixedRotation = def.fixedRotation;
    bodyDef.allowSleep = def.canSleep;
    bodyDef.awake = def.awake;
    b2Body* body = world.CreateBody(&bodyDef);
    addShapes(*body, sceneBody, restitutionThreshold, surfaces);
    if (def.type == BodyType::Dynamic && needsMass(def)) setMass(*body, massOf(def));
    // This comes last: a velocity in the def would be the origin's, and it would change when shapes move the centre of
    // mass.
    if (def.type != BodyType::Static) {
        body->SetLinearVelocity(toBox2d24(def.velocity));
        body->SetAngularVelocity(toSingle(def.angularVelocity));
    }
    return body;
}

void mixSurfaces24(b2Contact& contact) {
    static const Material plain;
    b2Fixture& a = *contact.GetFixtureA();
    b2Fixture& b = *contact.GetFixtureB();
    if (!surfaceOf(a) && !surfaceOf(b)) return;
    const Material& ofA = surfaceOf(a) ? *surfaceOf(a) : plain;
    const Material& ofB = surfaceOf(b) ? *surfaceOf(b) : plain;
    contact.SetFriction(mixed(ruleOf(ofA.frictionMix, ofB.frictionMix), a.GetFriction(), b.GetFriction()));
    contact.SetRestitution(
        mixed(ruleOf(ofA.restitutionMix, ofB.restitutionMix), a.GetRestitution(), b.GetRestitution()));
    // Box2D's tangent is the normal turned clockwise: so a positive speed runs clockwise around either body.
    contact.SetTangentSpeed(toSingle(ofA.surfaceSpeed + ofB.surfaceSpeed));
}

BodyState stateOf24(const b2Body& body) {
    const b2Vec2& position = body.GetPosition();
    const b2Vec2& velocity = body.GetLinearVelocity();
    return {{position.x, position.y}, body.GetAngle(), {velocity.x, velocity.y}, body.GetAngularVelocity()};
}

}  // namespace plumb::compare
