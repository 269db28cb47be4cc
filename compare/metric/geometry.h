// SPDX-License-Identifier: MIT
// How deep do a scene's bodies overlap, and how far are its joints torn?
#pragma once
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <compare/metric/joint_state.h>
#include <compare/metric/solid_shapes.h>
#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/broad/bvh.h>

namespace plumb::compare {

/// Measures shapes where the states put them, in double precision, without asking any engine.
class Geometry {
public:
    explicit Geometry(const Scene& scene);

    /// Some two bodies of the scene could touch: one of them is dynamic, their shapes' filters let them, no joint
    /// forbids it, and neither shape is a sensor or a one-way shape.
    bool anyMayTouch() const { return anyMayTouch_; }
    bool anyJoint() const { return !joints_.joints().empty(); }

    /// The deepest overlap of two shapes that may touch and are present, 0 when none do [m]. Empty when a state is not
    /// finite.
    std::optional<double> penetration(std::span<const BodyState> states) const;

    /// The farthest that a joint is from what it holds, but for those that have broken or are not there yet [m]. Empty
    /// when a state of a joined body is not finite. Bodies that it kept apart are still taken to be, when it has
    /// broken.
    std::optional<double> jointError(std::span<const BodyState> states, const Broken& broken = {}) const;

private:
    bool mayTouch(const SolidShape& a, const SolidShape& b) const;
    template <class Look>
    void forEachAround(const std::vector<Aabb>& boxes, Look&& look) const;

    Wrap wrap_;
    std::vector<SolidShape> shapes_;
    JointStates joints_;
    std::set<std::pair<std::size_t, std::size_t>> keptApart_;
    bool anyMayTouch_ = false;
};

}  // namespace plumb::compare
