// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/lane_collider.h>

#include <algorithm>

#include <plumb/dynamics/detail/lane_collider_wide.h>

namespace plumb {

template struct WideLaneCollider<1>;
#if defined(__GNUC__)
extern template struct WideLaneCollider<4>;
extern template struct WideLaneCollider<8>;
extern template struct WideLaneCollider<16>;
#endif

const LaneCollider& laneCollider(int lanes) {
#if defined(__GNUC__)
    const int wanted = std::min(lanes, machineLanes());
    if (wanted >= 16) return WideLaneCollider<16>::collider;
    if (wanted >= 8) return WideLaneCollider<8>::collider;
    if (wanted >= 4) return WideLaneCollider<4>::collider;
#endif
    return WideLaneCollider<1>::collider;
}

}  // namespace plumb
