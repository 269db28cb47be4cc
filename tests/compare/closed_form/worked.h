// SPDX-License-Identifier: MIT
// How exactly are the worked numbers of closed forms known?
#pragma once

namespace plumb::compare {

inline constexpr double digits = 6e-11;  // they have ten decimals

}  // namespace plumb::compare
