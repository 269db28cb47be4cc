// SPDX-License-Identifier: MIT
#include <Eigen/Core>

#include <map>
#include <set>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>

namespace plumb::compare {
namespace {

constexpr double dependent = 1e-10;    // a force depends on the others if less than this part is left without them [-]
constexpr double balanceSlack = 1e-6;  // the part of the weights that may remain without balance [-]

/// The bodies that joints tie to `first`, which comes first. Bodies that do not move end the search.
std::vector<HeldBody> tiedTo(const Scene& scene, const std::string& first) {
    std::vector<HeldBody> tied{heldBodyOf(scene, first)};
    std::set<std::string> known{first};
    for (std::size_t i = 0; i < tied.size(); ++i) {
        const std::string name = tied[i].scene->name;
        for (const SceneJoint& joint : scene.joints) {
            if (joint.bodyA != name && joint.bodyB != name) continue;
            const std::string& other = joint.bodyA == name ? joint.bodyB : joint.bodyA;
            if (other.empty() || scene.bodies[bodyIndex(scene, other)].def.type != BodyType::Dynamic) continue;
            if (known.insert(other).second) tied.push_back(heldBodyOf(scene, other));
        }
    }
    return tied;
}

/// Forces in joints that would hold all bodies still. Each row is a component of a body's force, or its torque.
class Balance {
public:
    explicit Balance(const std::vector<HeldBody>& bodies) : bodies_(bodies) {
        weights_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * bodies.size()));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            weights_.segment<2>(static_cast<Eigen::Index>(3 * i)) =
                Eigen::Vector2d(bodies[i].mass.mass * bodies[i].gravity);
            rowOf_[bodies[i].index] = static_cast<Eigen::Index>(3 * i);
        }
    }

    /// Adds a force of unknown size along a direction: on B, and opposite on A.
    void addForce(const JointGeometry& joint, const Vec2& onA, const Vec2& onB, const Vec2& direction) {
        columns_.push_back(Eigen::VectorXd::Zero(weights_.size()));
        push(joint.bodyB, onB, direction);
        push(joint.bodyA, onA, -direction);
    }

    /// The largest force that nothing balances, relative to the sum of the weights. It is the part of the weights at
    /// right angles to all forces that the joints can give, by the method of Gram and Schmidt.
    double unbalanced() const {
        const double all = weights_.lpNorm<1>();
        if (all == 0) return 0;
        std::vector<Eigen::VectorXd> span;  // each of length 1, at right angles to the others
        const auto without = [&span](Eigen::VectorXd forces) {
            for (int pass = 0; pass < 2; ++pass)  // the second pass removes the rounding of the first
                for (const Eigen::VectorXd& direction : span) forces -= direction.dot(forces) * direction;
            return forces;
        };
        for (const Eigen::VectorXd& column : columns_) {
            const Eigen::VectorXd rest = without(column);
            if (rest.norm() > dependent * column.norm()) span.push_back(rest.normalized());
        }
        return without(weights_).lpNorm<Eigen::Infinity>() / all;
    }

private:
    void push(std::size_t body, const Vec2& at, const Vec2& force) {
        const auto row = rowOf_.find(body);
        if (row == rowOf_.end()) return;
        const HeldBody& held = bodies_[static_cast<std::size_t>(row->second / 3)];
        columns_.back().segment<2>(row->second) += force;
        if (!held.scene->def.fixedRotation) columns_.back()[row->second + 2] += cross(Vec2(at - held.center), force);
    }

    const std::vector<HeldBody>& bodies_;
    Eigen::VectorXd weights_;
    std::map<std::size_t, Eigen::Index> rowOf_;
    std::vector<Eigen::VectorXd> columns_;
};

}  // namespace

WorkedMotion heldMotion(const RestsMotion& motion, const Scene& scene) {
    const std::vector<HeldBody> bodies = tiedTo(scene, motion.body);
    Balance balance(bodies);
    for (const HeldBody& body : bodies)
        if (body.scene->def.velocity != Vec2(0, 0) || body.scene->def.angularVelocity != 0)
            notKnown(body.scene->name, "it does not start at rest");
    for (const JointGeometry& joint : jointGeometries(scene)) {
        if (joint.bodyA == noBody || joint.bodyB == noBody) continue;
        const Vec2 onA = startPose(scene.bodies[joint.bodyA].def) * joint.localAnchorA;
        const Vec2 onB = startPose(scene.bodies[joint.bodyB].def) * joint.localAnchorB;
        if (std::holds_alternative<RevoluteJointDef>(joint.def)) {
            balance.addForce(joint, onA, onB, {1, 0});
            balance.addForce(joint, onA, onB, {0, 1});
        } else if (const auto* rod = std::get_if<DistanceJointDef>(&joint.def); rod && !rod->spring) {
            balance.addForce(joint, onA, onB, (onB - onA).normalized());
        }
    }
    if (balance.unbalanced() > balanceSlack) notKnown(motion.body, "it is not in balance where it starts");
    const BodyDef& def = bodies.front().scene->def;
    return {PiecewiseMotion{motion.body, {{.position = def.position, .angle = def.angle}}}};
}

}  // namespace plumb::compare
