// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_mover.h>

#include <cfloat>
#include <vector>

#include <compare/engine/box2d3/box2d3_body.h>

namespace plumb::compare {
namespace {

constexpr std::uint64_t characters = std::uint64_t{1} << 63;
constexpr int rounds = 5;
constexpr float nothingLeft = 0.01f;  // value of Box2D's sample [m]

b2ShapeId shapeOf(b2BodyId body) {
    b2ShapeId shape = b2_nullShapeId;
    b2Body_GetShapes(body, &shape, 1);
    return shape;
}

bool addPlane(b2ShapeId, const b2PlaneResult* found, void* planes) {
    if (found->hit)
        static_cast<std::vector<b2CollisionPlane>*>(planes)->push_back(
            {.plane = found->plane, .pushLimit = FLT_MAX, .push = 0, .clipVelocity = true});
    return true;
}

}  // namespace

void makeCharacter3(b2BodyId body) {
    const b2ShapeId shape = shapeOf(body);
    b2Filter filter = b2Shape_GetFilter(shape);
    filter.categoryBits = characters;
    b2Shape_SetFilter(shape, filter);
}

Vec2 characterVelocity3(b2WorldId world, b2BodyId body, const Vec2& wanted, double dt) {
    const b2ShapeId shape = shapeOf(body);
    b2QueryFilter others = b2DefaultQueryFilter();
    others.maskBits = b2Shape_GetFilter(shape).maskBits & ~characters;
    const b2Rot rotation = b2Body_GetRotation(body);
    b2Capsule mover = b2Shape_GetCapsule(shape);
    mover.center1 = b2RotateVector(rotation, mover.center1);
    mover.center2 = b2RotateVector(rotation, mover.center2);
    const b2Pos start = b2Body_GetPosition(body);
    const b2Vec2 target = toBox2d3(wanted * dt);
    b2Vec2 gone = b2Vec2_zero;
    for (int round = 0; round < rounds; ++round) {
        const b2Pos here = b2OffsetPos(start, gone);
        std::vector<b2CollisionPlane> planes;
        b2World_CollideMover(world, here, &mover, others, addPlane, &planes);
        const b2Vec2 way = b2SolvePlanes(b2Sub(target, gone), planes.data(), static_cast<int>(planes.size())).delta;
        const b2Vec2 step = b2MulSV(b2World_CastMover(world, here, &mover, way, others), way);
        gone = b2Add(gone, step);
        if (b2LengthSquared(step) < nothingLeft * nothingLeft) break;
    }
    return Vec2(gone.x, gone.y) / dt;
}

}  // namespace plumb::compare
