// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/lanes/lanes_wide.h>

template struct plumb::WideContactSolver<16>;
template struct plumb::WideLaneCollider<16>;
template struct plumb::WideSweptKernel<16>;
template struct plumb::WideBodySolver<16>;
template struct plumb::WideIslandKernel<16, plumb::LaneUse::Islands>;
#endif
