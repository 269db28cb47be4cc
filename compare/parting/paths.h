// SPDX-License-Identifier: MIT
// How far is a body from its path in another run?
#pragma once
#include <cstddef>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// Two runs of a body, with the same step. A result is NaN if one run does not describe the body, or does not have it
/// yet; infinite if a run has lost it.
class Paths {
public:
    Paths(const Scene& scene, const Observation& a, const Observation& b, std::size_t body)
        : wrap_(scene.wrap), a_(a), b_(b), body_(body) {}

    /// From its place in b to its place in a, at one moment [m].
    Vec2 wayAt(std::size_t tick) const;

    /// From the path of one run, within a step before and after, to the place of the body in the other; the shorter of
    /// both ways [m].
    Vec2 offsetAt(std::size_t tick) const;

private:
    double lostAt(std::size_t tick) const;
    Vec2 between(const Observation& of, std::size_t tick, const Observation& from, std::size_t fromTick) const;
    Vec2 toPath(const Observation& of, const Observation& path, std::size_t tick) const;

    const Wrap& wrap_;
    const Observation &a_, &b_;
    std::size_t body_;
};

/// The places of the bodies that may move.
std::vector<std::size_t> movingBodies(const Scene& scene);

/// How many ticks both runs have.
std::size_t ticksOf(const Observation& a, const Observation& b);

}  // namespace plumb::compare
