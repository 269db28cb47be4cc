// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/detail/contact_solver_wide.h>

template struct plumb::WideContactSolver<4>;
#endif
