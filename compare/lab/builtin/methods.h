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
    /// One step of the given length [s]; empty if the method chooses its steps by its tolerance.
    std::function<Motion(const MotionProblem& problem, const Motion& from, double step)> step{};
};

/// The methods of kit/plumb/integrate, from the simplest to the most exact.
std::vector<Method> knownMethods();

/// What a run may cost: only one of the two is used.
struct Effort {
    int steps = 1000;         ///< for a method with equal steps
    double tolerance = 1e-9;  ///< for a method that chooses its steps [m, m/s]
};

/// Runs from the problem's start until endTime [s]. Calls seen after each step, and returns the number of steps.
int walk(const Method& method, const MotionProblem& problem, double endTime, const Effort& effort,
         const std::function<void(double time, const Motion& motion)>& seen);

}  // namespace plumb::compare
