// SPDX-License-Identifier: MIT
// How does a template tell, as it is used, that it must not be?
#pragma once

namespace plumb::detail {

/// False, but not before the template is used: static_assert(never<T>, "write ... instead").
template <class T>
inline constexpr bool never = false;

}  // namespace plumb::detail
