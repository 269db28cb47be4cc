// SPDX-License-Identifier: MIT
// Which jointed bodies are thrown at rough ground?
#pragma once
#include <vector>

#include "kit/dynamics/grounds.h"

namespace plumb::test {

enum class MachineKind { Pair, Car, Doll, Rope };

struct ThrownMachine {
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    double widestGap(const World& world) const;  ///< the largest error of a joint [m]
};

/// A machine around a place, thrown at a velocity.
ThrownMachine addMachine(World& world, MachineKind kind, Random& random, const Vec2& at, const Vec2& velocity);

}  // namespace plumb::test
