// SPDX-License-Identifier: MIT
// Is a body kept from moving along an axis? A bool whose value true links the code of joints into the program.
#pragma once

namespace plumb {

class JointSolver;

/// Used like a bool. Locks are joints, and the value true brings the solver of joints with it: its constructor is
/// defined beside that solver, so a program that uses neither locks nor joints links none of that code.
class Lock {
public:
    constexpr Lock() = default;
    Lock(bool locked);  // NOLINT(google-explicit-constructor): .lockX = true

    constexpr operator bool() const { return solver_ != nullptr; }  // NOLINT(google-explicit-constructor)
    const JointSolver* solver() const { return solver_; }           ///< to be copied; nullptr: not locked

private:
    const JointSolver* solver_ = nullptr;
};

}  // namespace plumb
