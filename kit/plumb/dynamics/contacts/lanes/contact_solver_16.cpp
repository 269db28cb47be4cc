// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/dynamics/contacts/lanes/contact_solver_wide.h>

template struct plumb::WideContactSolver<16>;
#endif
