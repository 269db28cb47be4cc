// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/lanes/lanes_wide.h>

template struct plumb::WideContactSolver<4>;
template struct plumb::WideLaneCollider<4>;
template struct plumb::WideSweptKernel<4>;
template struct plumb::WideBodySolver<4>;
template struct plumb::WideIslandKernel<4, plumb::LaneUse::Islands>;
template struct plumb::WideIslandKernel<4, plumb::LaneUse::Joints>;
#endif
