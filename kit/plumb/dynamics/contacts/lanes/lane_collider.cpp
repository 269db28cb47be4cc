// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/lanes/lane_collider.h>

#include <plumb/dynamics/contacts/lanes/lane_collider_wide.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

template struct WideLaneCollider<1>;
#if defined(__GNUC__)
extern template struct WideLaneCollider<4>;
extern template struct WideLaneCollider<8>;
extern template struct WideLaneCollider<16>;
#endif

const LaneCollider& laneCollider(int lanes) {
#if defined(__GNUC__)
    return forLanes(lanes, WideLaneCollider<1>::collider, WideLaneCollider<4>::collider, WideLaneCollider<8>::collider,
                    WideLaneCollider<16>::collider);
#else
    (void)lanes;
    return WideLaneCollider<1>::collider;
#endif
}

}  // namespace plumb
