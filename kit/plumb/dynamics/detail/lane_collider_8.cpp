// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/detail/lane_collider_wide.h>

template struct plumb::WideLaneCollider<8>;
#endif
