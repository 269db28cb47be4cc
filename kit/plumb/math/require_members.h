// SPDX-License-Identifier: MIT
// Does each member of a definition hold what its description allows?
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <plumb/math/member.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// The name under which a definition is complained about. The text is made only for a complaint.
struct MemberPath {
    std::string_view name;               ///< "BodyDef", or, within another, "shapes"
    const MemberPath* within = nullptr;  ///< what it is a member of
    std::ptrdiff_t index = -1;           ///< in a list; -1: it is in none

    std::string text() const;                         ///< "BodyDef.shapes[0]"
    std::string text(std::string_view member) const;  ///< "BodyDef.shapes[0].material"
};

// Each throws std::invalid_argument with "<path>.<member>: <value> <what is wrong>" unless the value is as its name
// says.
void requireFinite(double value, const MemberPath& path, const char* member);
void requireFinite(const Vec2& value, const MemberPath& path, const char* member);
void requireFinite(std::span<const Vec2> values, const MemberPath& path, const char* member);
void requireNotNegative(double value, const MemberPath& path, const char* member);
void requirePositive(double value, const MemberPath& path, const char* member);
void requireWithin(double value, double low, double high, const MemberPath& path, const char* member);
/// instead: what to do for more than high.
void requireWithin(double value, double low, double high, const char* instead, const MemberPath& path,
                   const char* member);
void requireOneOf(double value, std::span<const int> choices, const MemberPath& path, const char* member);
/// number: of an enumerator; tags: of all that there are. An empty member: it is the path's own value.
void requireEnumerator(int number, std::span<const char* const> tags, const MemberPath& path, const char* member);
void requireUpTo(double value, double most, const char* why, const MemberPath& path, const char* member);
void requireUpTo(const Vec2& value, double most, const char* why, const MemberPath& path, const char* member);
[[noreturn]] void refuseZero(const char* value, const char* why, const MemberPath& path, const char* member);

// What follows is written out in place, so that of a description only what is checked gets into a program, and none of
// its texts.

[[gnu::always_inline]] inline void requireAllowed(double value, const Member& member, const MemberPath& path) {
    const Allowed& allowed = member.allowed;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (allowed.anything || (allowed.infinite && value == infinity)) return;
    if (allowed.minusInfinite && value == -infinity) return;
    if (allowed.isRange() && allowed.instead != nullptr)
        requireWithin(value, allowed.low, allowed.high, allowed.instead, path, member.name);
    else if (allowed.isRange())
        requireWithin(value, allowed.low, allowed.high, path, member.name);
    else if (!allowed.oneOf.empty())
        requireOneOf(value, allowed.oneOf, path, member.name);
    else if (allowed.sign == Allowed::Sign::Positive)
        requirePositive(value, path, member.name);
    else if (allowed.sign == Allowed::Sign::NotNegative)
        requireNotNegative(value, path, member.name);
    else
        requireFinite(value, path, member.name);
    if (allowed.beyond != nullptr) requireUpTo(value, allowed.most, allowed.beyond, path, member.name);
    if (allowed.zero != nullptr && value == 0) refuseZero("0", allowed.zero, path, member.name);
}

[[gnu::always_inline]] inline void requireAllowed(const Vec2& value, const Member& member, const MemberPath& path) {
    const Allowed& allowed = member.allowed;
    if (allowed.anything) return;
    requireFinite(value, path, member.name);
    if (allowed.beyond != nullptr) requireUpTo(value, allowed.most, allowed.beyond, path, member.name);
    if (allowed.zero != nullptr && value.isZero(0)) refuseZero("(0, 0)", allowed.zero, path, member.name);
}

template <class Def>
void requireMembers(const Def& def, const MemberPath& path);

template <class T>
inline constexpr bool isOptional = false;
template <class T>
inline constexpr bool isOptional<std::optional<T>> = true;

/// Throws std::invalid_argument unless a member holds what it may. What names something of a world, and what is one of
/// several alternatives, is for whoever knows more of it.
template <class T>
[[gnu::always_inline]] inline void requireMember(const Member& member, const T& value, const MemberPath& path) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>)
        requireAllowed(static_cast<double>(value), member, path);
    else if constexpr (std::is_same_v<T, Vec2>)
        requireAllowed(value, member, path);
    else if constexpr (std::is_same_v<T, std::vector<Vec2>>)
        requireFinite(value, path, member.name);
    else if constexpr (std::is_enum_v<T>)
        requireEnumerator(static_cast<int>(value), tagsOf(value), path, member.name);
    else if constexpr (Described<T>)
        requireMembers(value, {member.name, &path});
    else if constexpr (isOptional<T>) {
        if (value) requireMember(member, *value, path);
    } else {
        static_assert(!std::is_class_v<T>, "who checks this member has to say how");
    }
}

struct MemberCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        requireMember(member, value, path);
    }
};

/// Throws std::invalid_argument, naming the member, unless each member of a definition holds what its description
/// allows.
template <class Def>
void requireMembers(const Def& def, const MemberPath& path) {
    describe(def, MemberCheck{path});
}

}  // namespace plumb
