// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/hinge_solver.h>

#include <algorithm>

#include <plumb/dynamics/detail/hinge_solver_wide.h>

namespace plumb {

template struct WideHingeSolver<1>;
#if defined(__GNUC__)
extern template struct WideHingeSolver<4>;
extern template struct WideHingeSolver<8>;
extern template struct WideHingeSolver<16>;
#endif

const HingeSolver& hingeSolver(int lanes) {
#if defined(__GNUC__)
    const int wanted = std::min(lanes, machineLanes());
    if (wanted >= 16) return WideHingeSolver<16>::solver;
    if (wanted >= 8) return WideHingeSolver<8>::solver;
    if (wanted >= 4) return WideHingeSolver<4>::solver;
#endif
    return WideHingeSolver<1>::solver;
}

}  // namespace plumb
