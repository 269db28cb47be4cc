// SPDX-License-Identifier: MIT
// How many constraints stand side by side in memory, so that lanes can load them whole?
#pragma once

namespace plumb {

inline constexpr int batchLanes = 16;

/// One value of each lane. A plain array, for what is compiled for wider machines (see math/detail/wide.h).
template <class T>
using Lanes = T[batchLanes];

}  // namespace plumb
