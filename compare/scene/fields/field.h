// SPDX-License-Identifier: MIT
// What is said of a field of a scene's file, beside what is said of a member of the kit's definitions?
#pragma once
#include <cstddef>

#include <plumb/math/member.h>

namespace plumb::compare {

struct Field : Member {
    bool needed = false;    ///< a file must have it
    std::size_t least = 0;  ///< so many letters of a text, or elements of a list, are wanted

    constexpr Field(const char* name, const char* unit, const Allowed& allowed, const char* meaning)
        : Member{name, unit, allowed, meaning} {}
    constexpr explicit Field(const Member& member, bool isNeeded = false, std::size_t atLeast = 0)
        : Member(member), needed(isNeeded), least(atLeast) {}
};

constexpr Field needed(const Member& member, std::size_t least = 1) {
    return Field(member, true, least);
}
/// May be left out, but not be empty.
constexpr Field notEmpty(const Member& member) {
    return Field(member, false, 1);
}

}  // namespace plumb::compare
