// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_pushes.h>

#include <map>

#include <compare/engine/box2d3/box2d3_body.h>

namespace plumb::compare {
namespace {

Vec2 vec(b2Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

bool canMove(b2BodyId body) {
    return b2Body_GetType(body) == b2_dynamicBody;
}

class PushReader {
public:
    explicit PushReader(const Stepped3& stepped) : stepped_(stepped) {
        for (std::size_t i = 0; i < stepped.bodies.size(); ++i)
            if (B2_IS_NON_NULL(stepped.bodies[i])) places_[stepped.bodies[i].index1] = i;
    }

    std::vector<Push> read() {
        for (const auto& [id, body] : places_)
            if (canMove(stepped_.bodies[body])) addContacts(body);
        for (std::size_t i = 0; i < stepped_.joints.size(); ++i)
            if (b2Joint_IsValid(stepped_.joints[i]) && stepped_.geometries[i].bodyB != noBody) addJoint(i);
        return pushes_;
    }

private:
    void addContacts(std::size_t body) {
        const b2BodyId id = stepped_.bodies[body];
        std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(id)));
        contacts.resize(
            static_cast<std::size_t>(b2Body_GetContactData(id, contacts.data(), static_cast<int>(contacts.size()))));
        for (const b2ContactData& contact : contacts) addContact(body, contact);
    }

    void addContact(std::size_t body, const b2ContactData& contact) {
        const b2BodyId a = b2Shape_GetBody(contact.shapeIdA), b = b2Shape_GetBody(contact.shapeIdB);
        const bool isB = B2_ID_EQUALS(b, stepped_.bodies[body]);
        const auto other = places_.find(isB ? a.index1 : b.index1);
        if (other == places_.end()) return;
        const double side = isB ? 1 : -1;
        const Vec2 normal = vec(contact.manifold.normal), along(normal.y(), -normal.x());
        const Vec2 center = vec(b2Body_GetWorldCenter(a));
        for (int i = 0; i < contact.manifold.pointCount; ++i) {
            const b2ManifoldPoint& point = contact.manifold.points[i];
            const Vec2 at = center + vec(point.anchorA);
            const double press = static_cast<double>(point.totalNormalImpulse) / stepped_.dt;
            const double rub = static_cast<double>(point.tangentImpulse) * stepped_.subSteps / stepped_.dt;
            pushes_.push_back({Cause::Normal, body, other->second, at, side * press * normal});
            pushes_.push_back({Cause::Friction, body, other->second, at, side * rub * along});
        }
    }

    void addJoint(std::size_t joint) {
        const Vec2 force = vec(b2Joint_GetConstraintForce(stepped_.joints[joint]));
        const JointGeometry& geometry = stepped_.geometries[joint];
        const auto on = [&](std::size_t body, const Vec2& anchor, double side) {
            const b2BodyId id = stepped_.bodies[body];
            if (!canMove(id)) return;
            pushes_.push_back(
                {Cause::Joint, body, joint, vec(b2Body_GetWorldPoint(id, toBox2d3(anchor))), side * force});
        };
        on(geometry.bodyB, geometry.localAnchorB, 1);
        if (geometry.bodyA != noBody) on(geometry.bodyA, geometry.localAnchorA, -1);
    }

    Stepped3 stepped_;
    std::map<int, std::size_t> places_;  // of the scene's bodies, by the index of their ids
    std::vector<Push> pushes_;
};

}  // namespace

std::vector<Push> pushes3(const Stepped3& stepped) {
    return PushReader(stepped).read();
}

b2JointId handJoint3(b2WorldId world, b2BodyId body, const Hand& hand) {
    const b2BodyDef ground = b2DefaultBodyDef();
    b2MotorJointDef made = b2DefaultMotorJointDef();
    made.base.bodyIdA = b2CreateBody(world, &ground);
    made.base.bodyIdB = body;
    made.base.localFrameA.p = toBox2d3(hand.target);
    made.base.localFrameB.p = toBox2d3(hand.grip);
    made.base.collideConnected = true;
    made.linearHertz = 5;
    made.linearDampingRatio = 0.7f;
    made.maxSpringForce = 1e9f;
    b2Body_SetAwake(body, true);
    return b2CreateMotorJoint(world, &made);
}

void releaseHand3(b2JointId hand) {
    b2DestroyBody(b2Joint_GetBodyA(hand));
}

}  // namespace plumb::compare
