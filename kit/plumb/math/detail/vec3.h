// SPDX-License-Identifier: MIT
// Three numbers: of up to three rows of a joint.
#pragma once
#include <array>

namespace plumb {

using Vec3 = std::array<double, 3>;

}  // namespace plumb
