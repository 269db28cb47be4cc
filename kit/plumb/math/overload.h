// SPDX-License-Identifier: MIT
// How does a call with a wrong type, or with empty braces, find its overload, or an error that says what to write?
#pragma once
#include <type_traits>
#include <variant>

namespace plumb::detail {

/// Is a type one of a variant's alternatives?
template <class T, class Variant>
inline constexpr bool isAlternative = false;
template <class T, class... Types>
inline constexpr bool isAlternative<T, std::variant<Types...>> = (std::is_same_v<T, Types> || ...);

template <class T, class Variant>
concept AlternativeOf = isAlternative<T, Variant>;

/// False, but not before the template is used: static_assert(never<T>, "write ... instead").
template <class T>
inline constexpr bool never = false;

/// What does X x({}) mean, for a class X that is made from a definition?
/// Empty braces are converted to this enumeration without a user-defined conversion, so a constructor that takes it is
/// preferred to those that take a definition or another X, which would be ambiguous.
enum class EmptyBraces {};

}  // namespace plumb::detail
