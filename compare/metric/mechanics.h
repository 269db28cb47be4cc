// SPDX-License-Identifier: MIT
// How much energy and momentum do a scene's moving bodies have?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <compare/field/scene_fields.h>
#include <compare/metric/joint_state.h>
#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// Sums over the dynamic bodies that are there.
struct Mechanics {
    double kinetic = 0;          ///< sum of m v^2 / 2 + I w^2 / 2 [J]
    double potential = 0;        ///< sum of -m s g.c, zero at the world's origin; s the body's gravity scale [J]
    double lifted = 0;           ///< potential minus that of the start, summed body by body without cancellation [J]
    double elastic = 0;          ///< in the springs of joints that have not broken: sum of k x^2 / 2 [J]
    double field = 0;            ///< of the bodies in fields that have a potential energy [J]
    Vec2 momentum{0, 0};         ///< sum of m v [N s]
    double momentumSize = 0;     ///< sum of |m v| [N s]
    double angularMomentum = 0;  ///< sum of m (c - o) x v + I w, o the centre of all masses at the start [N m s]
    double angularMomentumSize = 0;  ///< sum of m |c - o| |v| + I |w| [N m s]
};

/// Masses and starting places of a scene's bodies, and its springs, as the scene gives them: the same for every engine.
class MassModel {
public:
    explicit MassModel(const Scene& scene);

    /// Empty when the state of a dynamic body is not finite.
    std::optional<Mechanics> at(std::span<const BodyState> states, const Broken& broken = {}) const;

    /// The fastest point of any dynamic body moves this fast: |v| + |w| r, r from the centre of mass to the farthest
    /// point of its shapes [m/s]. Empty when a state is not finite.
    std::optional<double> fastestPoint(std::span<const BodyState> states) const;

    bool anyDynamic() const { return !moving_.empty(); }
    /// Indices of the scene's dynamic bodies.
    std::vector<std::size_t> dynamicBodies() const;

private:
    struct Moving {
        std::size_t body;
        Mass mass;
        double gravityScale;
        Vec2 startCenter;
        double reach;
    };
    Vec2 gravity_;
    Vec2 startCenter_{0, 0};
    std::vector<Moving> moving_;
    JointStates joints_;
    SceneFields fields_;
};

/// Centre of mass in the world.
Vec2 centerOf(const BodyState& state, const Mass& mass);

}  // namespace plumb::compare
