// SPDX-License-Identifier: MIT
// Is a body kept from moving along an axis? A bool whose value true links the code of joints into the program.
#pragma once

namespace plumb {

struct JointEdits;

/// Used like a bool. Locks are joints. The constructor from a bool is defined with the edits of joints, so a program
/// that uses neither locks nor joints links none of that code.
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
