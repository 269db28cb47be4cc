// SPDX-License-Identifier: MIT
// Is a body kept from moving along an axis? A yes or no, whose yes brings the joints into the program.
#pragma once

namespace plumb {

struct JointEdits;

/// Used as a bool is. Locks are joints, and a program that locks nothing and joins nothing links no code of joints: so
/// the yes is where that code is, and only who says yes needs it.
class Lock {
public:
    constexpr Lock() = default;
    Lock(bool locked);  // NOLINT(google-explicit-constructor): .lockX = true

    constexpr operator bool() const { return joints_ != nullptr; }  // NOLINT(google-explicit-constructor)
    const JointEdits* joints() const { return joints_; }            ///< nullptr: not locked

private:
    const JointEdits* joints_ = nullptr;
};

}  // namespace plumb
