// SPDX-License-Identifier: MIT
// How far are a scene's joints from what they hold?
#pragma once
#include <span>
#include <vector>

#include <compare/scene/joint_geometry.h>
#include <compare/scene/scene.h>
#include <compare/scene/state.h>

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

    /// How far the joint is from what it holds [m]. Of a hinge or a stiff weld: how far its anchors are apart. Of a
    /// slide or a wheel: across its axis, and along it beyond its limit. Of a rod: from its length; of a spring: beyond
    /// its shortest and longest. Of a pulley: by how much its rope is too long (it may be slack). Of a gear with a
    /// slide: how far the slide is from where the other joint wants it. 0 for a gear of two hinges, and for what only
    /// pulls.
    double gap(std::size_t joint, std::span<const BodyState> states) const;

    /// By how much a hinge's angle or a slide's or wheel's shift is outside of its limit, 0 inside [rad or m].
    double beyondLimit(std::size_t joint, std::span<const BodyState> states) const;

    /// What is in its springs: k x^2 / 2 of each [J].
    double springEnergy(std::size_t joint, std::span<const BodyState> states) const;

private:
    /// Where the joint's two sides are, relative to each other.
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
