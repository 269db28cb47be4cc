// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/hinge_solver.h>

#include <plumb/dynamics/joints/hinge_solver_wide.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

template struct WideHingeSolver<1>;
#if defined(__GNUC__)
extern template struct WideHingeSolver<4>;
extern template struct WideHingeSolver<8>;
extern template struct WideHingeSolver<16>;
#endif

const HingeSolver& hingeSolver(int lanes) {
#if defined(__GNUC__)
    return forLanes(lanes, WideHingeSolver<1>::solver, WideHingeSolver<4>::solver, WideHingeSolver<8>::solver,
                    WideHingeSolver<16>::solver);
#else
    (void)lanes;
    return WideHingeSolver<1>::solver;
#endif
}

}  // namespace plumb
