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
#if !defined(__wasm__)
template struct WideIslandKernel<1, LaneUse::Islands>;
#endif
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
extern template struct WideIslandKernel<4, LaneUse::Islands>;
extern template struct WideIslandKernel<8, LaneUse::Islands>;
extern template struct WideIslandKernel<16, LaneUse::Islands>;
extern template struct WideIslandKernel<4, LaneUse::Joints>;
extern template struct WideIslandKernel<8, LaneUse::Joints>;
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

IslandCode islandCode(int islands, int lanes) {
    const auto alone = []<int W>() -> IslandCode {
        constexpr int floats = std::min(W, 8);  // wider ones would be half empty in most machines
        if constexpr (W == 1)
            return {&WideIslandKernel<1, LaneUse::Islands>::code};
        else
            return {&WideIslandKernel<floats, LaneUse::Joints>::code, LaneUse::Joints, std::size_t{floats / 2}};
    };
    const auto together = [islands]<int W>() -> IslandCode {
        return {&WideIslandKernel<W, LaneUse::Islands>::code, LaneUse::Islands, static_cast<std::size_t>(islands)};
    };
    return islands == 1 ? forLanes(lanes, alone) : forLanes(2 * islands, together);
}

const BodySolver& bodySolver(int lanes) {
    return codeFor<BodySolver, WideBodySolver>(lanes);
}

}  // namespace plumb
