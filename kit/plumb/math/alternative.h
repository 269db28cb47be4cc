// SPDX-License-Identifier: MIT
// Is a type one of a variant's alternatives?
#pragma once
#include <type_traits>
#include <variant>

namespace plumb::detail {

template <class T, class Variant>
inline constexpr bool isAlternative = false;
template <class T, class... Types>
inline constexpr bool isAlternative<T, std::variant<Types...>> = (std::is_same_v<T, Types> || ...);

template <class T, class Variant>
concept AlternativeOf = isAlternative<T, Variant>;

}  // namespace plumb::detail
