// SPDX-License-Identifier: MIT
// Which methods of integration are compared?
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <compare/lab/builtin/orbits.h>

namespace plumb::compare {

struct Method {
    std::string name{};
    std::string tag{};  ///< in the names of checks
    int order = 1;
    /// A step of a length [s]; empty: it steps as long as its tolerance allows.
    std::function<Motion(const MotionProblem& problem, const Motion& from, double step)> step{};
};

/// Those of kit/plumb/integrate, from the simplest to the most exact.
std::vector<Method> knownMethods();

/// What a run may cost: the one or the other.
struct Effort {
    int steps = 1000;         ///< of a method whose steps are even
    double tolerance = 1e-9;  ///< of one that chooses its steps [m, m/s]
};

/// From the problem's start until endTime [s]; calls seen after each step, and returns how many there were.
int walk(const Method& method, const MotionProblem& problem, double endTime, const Effort& effort,
         const std::function<void(double time, const Motion& motion)>& seen);

}  // namespace plumb::compare
