// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/lanes/lanes_wide.h>

template struct plumb::WideContactSolver<8>;
template struct plumb::WideLaneCollider<8>;
template struct plumb::WideSweptKernel<8>;
template struct plumb::WideBodySolver<8>;
template struct plumb::WideIslandKernel<8, plumb::LaneUse::Islands>;
template struct plumb::WideIslandKernel<8, plumb::LaneUse::Joints>;
#endif
