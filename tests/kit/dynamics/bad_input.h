// SPDX-License-Identifier: MIT
// How is a world asked for what it must refuse, and what has become of it then?
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <plumb/plumb.h>

#include "numbers.h"

namespace plumb::test {

/// Parameters of functions that a table spoils, by the function's name.
using Covered = std::map<std::string, std::vector<std::string>>;
Covered coveredCalls();

/// A world with something of everything in it, to which bad input is given.
struct Bench {
    World world, other;
    BodyId floor, lift, ball, crate, sleeper, gone, foreign, wall;
    JointId hinge, slide, rod, goneJoint, foreignJoint;
    ShapeId ballShape, goneShape, liftShape;
    Bench();
};

/// All that can be seen of a world, to the last bit, and in words.
std::string stateOf(const World& world);

/// Calls, and says why it was refused; "" if it was not.
std::string refusalOf(const std::function<void()>& call);

/// Says how the refusal is not what it should be, or how the world has changed; "" when all is well.
std::string faultOf(Bench& bench, const std::function<void()>& call, const std::string& field,
                    const std::string& complaint);

/// Numbers that a float cannot hold, or hardly.
inline const std::vector<double> extremes{1e-320, 1e-30, 1e12, 1e39, 1e160, 1.7e308, infinity};

/// Steps for a second, and tells of a body that is neither finite nor in quarantine; "" if there is none.
std::string unsoundAfter(World& world);
/// And of one that is in quarantine.
std::string unsoundOrQuarantinedAfter(World& world);

}  // namespace plumb::test
