// SPDX-License-Identifier: MIT
// Is a body kept from moving along an axis? A bool whose value true links the code of joints into the program.
#pragma once

namespace plumb {

class JointSolver;

/// Used like a bool. Locks are joints, and what solves joints is made by the value true itself: its constructor is
/// defined beside that code, so a program that uses neither locks nor joints links none of it.
class Lock {
public:
    using Maker = JointSolver* (*)();  ///< its caller owns what it makes

    constexpr Lock() = default;
    Lock(bool locked);  // NOLINT(google-explicit-constructor): .lockX = true

    constexpr operator bool() const { return solver_ != nullptr; }  // NOLINT(google-explicit-constructor)
    Maker solver() const { return solver_; }                        ///< nullptr: not locked

private:
    Maker solver_ = nullptr;
};

}  // namespace plumb
