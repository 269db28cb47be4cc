// SPDX-License-Identifier: MIT
// What is known of a field in a scene's file, in addition to what is known of a member of the kit's definitions?
#pragma once
#include <cstddef>

#include <plumb/math/member.h>

namespace plumb::compare {

struct Field : Member {
    bool needed = false;    ///< a file must have it
    std::size_t least = 0;  ///< the least number of letters of a text, or of elements of a list

    constexpr Field(const char* name, const char* unit, const Allowed& allowed, const char* meaning)
        : Member{name, unit, allowed, meaning} {}
    constexpr explicit Field(const Member& member, bool isNeeded = false, std::size_t atLeast = 0)
        : Member(member), needed(isNeeded), least(atLeast) {}
};

constexpr Field needed(const Member& member, std::size_t least = 1) {
    return Field(member, true, least);
}
/// A field that may be left out, but must not be empty.
constexpr Field notEmpty(const Member& member) {
    return Field(member, false, 1);
}

}  // namespace plumb::compare
