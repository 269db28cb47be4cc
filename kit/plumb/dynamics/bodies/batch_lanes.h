// SPDX-License-Identifier: MIT
// How many constraints are stored side by side, so that one vector operation can load a value of several of them?
#pragma once

namespace plumb {

inline constexpr int batchLanes = 16;

/// One value for each lane. A plain array, so that code compiled for wider machines can use it (see
/// math/detail/wide.h).
template <class T>
using Lanes = T[batchLanes];

}  // namespace plumb
