// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/solver/body_solver_wide.h>

template struct plumb::WideBodySolver<16>;
#endif
