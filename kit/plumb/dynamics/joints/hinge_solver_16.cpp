// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/joints/hinge_solver_wide.h>

template struct plumb::WideHingeSolver<16>;
#endif
