// SPDX-License-Identifier: MIT
// How do a scene's joints stand when its bodies are somewhere?
#pragma once
#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/engine/joint_geometry.h>

namespace plumb::compare {

/// Measured from the bodies' states alone, without asking any engine. A joint is named by its place in the scene; its
/// bodies' states must be finite.
class JointStates {
public:
    explicit JointStates(const Scene& scene);

    const std::vector<JointGeometry>& joints() const { return joints_; }

    /// The joint's bodies are there.
    bool isPresent(std::size_t joint, std::span<const BodyState> states) const;

    /// The states of the joint's bodies are numbers.
    bool isKnown(std::size_t joint, std::span<const BodyState> states) const;

    /// How far the joint's anchors are from where it wants them, in the directions in which it leaves them no freedom
    /// [m]: a hinge's or stiff weld's apart; across a slide's or wheel's axis, and along it beyond its limit; a rod's
    /// from its length, a spring's beyond its shortest and longest; a pulley's rope too long (it may be slack); a
    /// gear's slide from where its partner should have it. Between two hinges, and of what only pulls, it is 0.
    double gap(std::size_t joint, std::span<const BodyState> states) const;

    /// By how much a hinge's angle or a slide's or wheel's shift is outside of its limit, 0 inside [rad or m].
    double beyondLimit(std::size_t joint, std::span<const BodyState> states) const;

    /// What is in its springs: k x^2 / 2 of each [J].
    double springEnergy(std::size_t joint, std::span<const BodyState> states) const;

private:
    /// Where the two sides are against each other.
    struct Sides {
        Vec2 apart{0, 0};              ///< from A's anchor to B's, in A's frame [m]
        double along = 0, across = 0;  ///< the same along the axis and to its left [m]
        double turned = 0;             ///< of B against A since the start [rad]
    };
    Sides sidesOf(const JointGeometry& joint, std::span<const BodyState> states) const;
    double coordinate(const JointGeometry& joint, std::span<const BodyState> states) const;
    double ropeOf(const JointGeometry& joint, const PulleyJointDef& def, std::span<const BodyState> states) const;

    std::vector<JointGeometry> joints_;
    std::vector<double> startAngles_;    ///< of the scene's bodies [rad]
    std::vector<Spring> targetSprings_;  ///< by joint, of a target
};

}  // namespace plumb::compare
