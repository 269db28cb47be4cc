// SPDX-License-Identifier: MIT
// Which code does a step run: that for 1, 4, 8 or 16 lanes? The widest that the machine supports and that has no more
// lanes than requested.
#include <plumb/dynamics/lanes/lanes_wide.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

/// The code for one lane is compiled here, for any machine. That for more lanes is in sources of their own, each
/// compiled with the flags of its instruction set: only there may the compiler use these instructions.
template struct WideContactSolver<1>;
template struct WideLaneCollider<1>;
template struct WideSweptKernel<1>;
template struct WideBodySolver<1>;
template struct WideIslandKernel<1>;
#if defined(__GNUC__)
extern template struct WideContactSolver<4>;
extern template struct WideContactSolver<8>;
extern template struct WideContactSolver<16>;
extern template struct WideLaneCollider<4>;
extern template struct WideLaneCollider<8>;
extern template struct WideLaneCollider<16>;
extern template struct WideSweptKernel<4>;
extern template struct WideSweptKernel<8>;
extern template struct WideSweptKernel<16>;
extern template struct WideBodySolver<4>;
extern template struct WideBodySolver<8>;
extern template struct WideBodySolver<16>;
extern template struct WideIslandKernel<4>;
extern template struct WideIslandKernel<8>;
extern template struct WideIslandKernel<16>;
#endif

namespace {

template <class Code, template <int> class Wide>
const Code& codeFor(int lanes) {
    return forLanes(lanes, []<int W>() -> const Code& { return Wide<W>::code; });
}

}  // namespace

const ContactSolver& contactSolver(int lanes) {
    if (lanes == 1) return WideContactSolver<1>::code;  // contacts that share bodies have to be solved one by one
    return codeFor<ContactSolver, WideContactSolver>(lanes);
}

const LaneCollider& laneCollider(int lanes) {
    return codeFor<LaneCollider, WideLaneCollider>(lanes);
}

const SweptKernel& sweptKernel(int lanes) {
    return codeFor<SweptKernel, WideSweptKernel>(lanes);
}

/// Islands are solved in doubles, of which half as many fit into a register.
int islandLanes(int lanes) {
    return std::max(1, std::min(lanes, machineLanes()) / 2);
}

const IslandKernel& islandKernel(int islands) {
    if (islands == 1) return WideIslandKernel<1>::code;
    return codeFor<IslandKernel, WideIslandKernel>(2 * islands);
}

const BodySolver& bodySolver(int lanes) {
    return codeFor<BodySolver, WideBodySolver>(lanes);
}

}  // namespace plumb
