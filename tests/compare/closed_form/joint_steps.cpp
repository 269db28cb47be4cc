// SPDX-License-Identifier: MIT
#include "compare/closed_form/joint_steps.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include <plumb/shapes/mass.h>

namespace plumb::compare {
namespace {

using Column = Eigen::VectorXd;

/// Of each body x, y, angle.
class Jointed {
public:
    explicit Jointed(const Scene& scene) : scene_(scene), size_(static_cast<Eigen::Index>(3 * scene.bodies.size())) {
        q_ = v_ = weight_ = Column::Zero(size_);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const BodyDef& def = scene.bodies[i].def;
            const Eigen::Index at = static_cast<Eigen::Index>(3 * i);
            q_.segment<3>(at) << def.position.x(), def.position.y(), def.angle;
            v_.segment<3>(at) << def.velocity.x(), def.velocity.y(), def.angularVelocity;
            const Mass mass = def.type == BodyType::Dynamic ? massOf(def) : Mass{};
            weight_.segment<3>(at) << mass.mass, mass.mass, mass.inertia;
            if (def.fixedRotation) weight_[at + 2] = 1e12;
        }
        start_ = q_;
        held_ = constraints(q_);
    }

    Column acceleration(const Column& q, const Column& v) const {
        const Eigen::Index rows = held_.size();
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size_ + rows, size_ + rows);
        Column right = Column::Zero(size_ + rows);
        right.head(size_) = forces(q, v);
        for (Eigen::Index k = 0; k < size_; ++k) {
            const bool moves = weight_[k] > 0;
            all(k, k) = moves ? weight_[k] : 1;
            if (!moves) {
                right[k] = 0;
                continue;
            }
            constexpr double h = 1e-5;
            Column there = q, back = q;
            there[k] += h, back[k] -= h;
            const Column slope = (constraints(there) - constraints(back)) / (2 * h);
            all.block(size_, k, rows, 1) = slope;
            all.block(k, size_, 1, rows) = slope.transpose();
        }
        if (rows > 0 && v.norm() > 0) {
            const double h = 1e-4 / v.norm();
            right.tail(rows) = -(constraints(q + h * v) - 2 * constraints(q) + constraints(q - h * v)) / (h * h);
        }
        return all.completeOrthogonalDecomposition().solve(right).head(size_);
    }

    void step(double h) {
        const Column q = q_, v = v_;
        const Column a1 = acceleration(q, v), v2 = v + h / 2 * a1;
        const Column a2 = acceleration(q + h / 2 * v, v2), v3 = v + h / 2 * a2;
        const Column a3 = acceleration(q + h / 2 * v2, v3), v4 = v + h * a3;
        const Column a4 = acceleration(q + h * v3, v4);
        q_ = q + h / 6 * (v + 2 * v2 + 2 * v3 + v4);
        v_ = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }

    std::vector<BodyState> states() const {
        std::vector<BodyState> states;
        for (Eigen::Index k = 0; k < size_; k += 3)
            states.push_back({{q_[k], q_[k + 1]}, q_[k + 2], {v_[k], v_[k + 1]}, v_[k + 2]});
        return states;
    }
    Column startAcceleration() const { return acceleration(q_, v_); }

private:
    Eigen::Index find(const std::string& name) const {
        const auto found = std::ranges::find(scene_.bodies, name, &SceneBody::name);
        return 3 * (found - scene_.bodies.begin());
    }
    const SceneJoint& jointNamed(const std::string& name) const {
        return *std::ranges::find(scene_.joints, name, &SceneJoint::name);
    }
    /// Where a point is that a body had at a place at the start.
    Vec2 carried(const Column& q, Eigen::Index body, const Vec2& place) const {
        const Vec2 arm(place.x() - start_[body], place.y() - start_[body + 1]);
        const double turned = q[body + 2] - start_[body + 2], c = std::cos(turned), s = std::sin(turned);
        return {q[body] + c * arm.x() - s * arm.y(), q[body + 1] + s * arm.x() + c * arm.y()};
    }
    double coordinate(const Column& q, const SceneJoint& joint) const {
        const Eigen::Index a = find(joint.bodyA), b = find(joint.bodyB);
        if (std::holds_alternative<RevoluteJointDef>(joint.def)) return q[b + 2] - q[a + 2];
        const auto& slide = std::get<PrismaticJointDef>(joint.def);
        return slide.axis.normalized().dot(carried(q, b, slide.anchor) - carried(q, a, slide.anchor));
    }

    Column constraints(const Column& q) const {
        std::vector<double> rows;
        const auto both = [&](const Vec2& v) { rows.push_back(v.x()), rows.push_back(v.y()); };
        for (const SceneJoint& joint : scene_.joints) {
            if (const auto* gear = std::get_if<GearJointDef>(&joint.def)) {
                rows.push_back(coordinate(q, jointNamed(joint.jointA)) +
                               gear->ratio * coordinate(q, jointNamed(joint.jointB)));
                continue;
            }
            const Eigen::Index a = find(joint.bodyA), b = find(joint.bodyB);
            if (const auto* hinge = std::get_if<RevoluteJointDef>(&joint.def))
                both(carried(q, b, hinge->anchor) - carried(q, a, hinge->anchor));
            if (const auto* slide = std::get_if<PrismaticJointDef>(&joint.def)) {
                const Vec2 off = carried(q, b, slide->anchor) - carried(q, a, slide->anchor), axis = slide->axis;
                rows.push_back(axis.x() * off.y() - axis.y() * off.x());
                rows.push_back(q[b + 2] - q[a + 2]);
            }
            if (const auto* rod = std::get_if<DistanceJointDef>(&joint.def); rod && !rod->spring)
                rows.push_back((carried(q, b, rod->anchorB) - carried(q, a, rod->anchorA)).norm());
            if (const auto* rope = std::get_if<PulleyJointDef>(&joint.def))
                rows.push_back((carried(q, a, rope->anchorA) - rope->groundA).norm() +
                               rope->ratio * (carried(q, b, rope->anchorB) - rope->groundB).norm());
        }
        return Eigen::Map<const Column>(rows.data(), static_cast<Eigen::Index>(rows.size()));
    }

    Column forces(const Column& q, const Column& v) const {
        Column f = Column::Zero(size_);
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
            f.segment<2>(static_cast<Eigen::Index>(3 * i)) = Eigen::Vector2d(
                weight_[static_cast<Eigen::Index>(3 * i)] * scene_.bodies[i].def.gravityScale * scene_.gravity);
        for (const SceneJoint& joint : scene_.joints) addJoint(joint, q, v, f);
        for (const SceneField& field : scene_.fields) addField(field, q, f);
        return f;
    }

    void addJoint(const SceneJoint& joint, const Column& q, const Column& v, Column& f) const {
        if (const auto* hinge = std::get_if<RevoluteJointDef>(&joint.def))
            f[find(joint.bodyB) + 2] += hinge->maxMotorTorque;
        const auto* spring = std::get_if<DistanceJointDef>(&joint.def);
        if (!spring || !spring->spring) return;
        const Eigen::Index b = find(joint.bodyB);
        const Vec2 apart = Vec2(q[b], q[b + 1]) - spring->anchorA, way = apart.normalized();
        const double speed = way.dot(Vec2(v[b], v[b + 1]));
        f.segment<2>(b) -=
            (spring->spring->stiffness * (apart.norm() - *spring->length) + spring->spring->damping * speed) * way;
    }

    void addField(const SceneField& field, const Column& q, Column& f) const {
        if (const auto* pool = std::get_if<Pool>(&field.def.law)) {
            const Eigen::Index b = find(scene_.closedForm->bodies.size() == 1 ? scene_.bodies[0].name : "");
            const auto& box = std::get<Polygon>(scene_.bodies[0].def.shapes[0].shape);
            const double wide = 2 * std::abs(box.vertices[0].x()), low = q[b + 1] - std::abs(box.vertices[0].y());
            const double deep = std::clamp(pool->fluid.surface.y() - low, 0.0, 2 * std::abs(box.vertices[0].y()));
            f.segment<2>(b) -= pool->fluid.density * wide * deep * pool->fluid.gravity;
            return;
        }
        const Vec2 apart(q[3] - q[0], q[4] - q[1]);
        double pull = 0;
        if (const auto* law = std::get_if<MutualGravity>(&field.def.law))
            pull = law->constant * weight_[0] * weight_[3];
        if (const auto* magnet = std::get_if<Magnet>(&field.def.law)) pull = magnet->pull.strength;
        const Vec2 force = pull / std::pow(apart.norm(), 3) * apart;
        f.segment<2>(0) += force;
        f.segment<2>(3) -= force;
    }

    const Scene& scene_;
    Eigen::Index size_;
    Column q_, v_, weight_, start_, held_;
};

}  // namespace

std::vector<std::vector<BodyState>> jointSteps(const Scene& scene, const std::vector<double>& times, double step) {
    Jointed jointed(scene);
    std::vector<std::vector<BodyState>> rows;
    double now = 0;
    for (const double time : times) {
        const int count = std::max(1, static_cast<int>(std::ceil((time - now) / step)));
        for (int i = 0; i < count && time > now; ++i) jointed.step((time - now) / count);
        now = time;
        rows.push_back(jointed.states());
    }
    return rows;
}

double startAcceleration(const Scene& scene) {
    return Jointed(scene).startAcceleration().lpNorm<Eigen::Infinity>();
}

}  // namespace plumb::compare
