// SPDX-License-Identifier: MIT
// On which part of their curves are rows of W islands, and which equations hold there?
//
// A row has the speed v = sum over its ends of (x, y, turn) . (vx, vy, w), and applies (x, y, turn) times its impulse L
// to each end. Its condition is L = impulse of a spring - d v + the value of its curve at v. The curve falls as v
// grows; the rows of a hinge, a motor and a limit are each parts of it:
//
//      L |      lower stop
//        |        |
//   high |        +------.          v below the target: the motor's greatest impulse
//        |               | target
//    low |               '------.   v above it: the greatest impulse the other way
//        |                      |
//        +----------------------+--- v
//                       upper stop
//
// A damper c removes the share 1 - exp(-c w h / 2) of v in half a sub-step h, if nothing else acts. w is the effective
// inverse mass, the change of v by a unit of L. So d = (exp(c w h / 2) - 1) / w, for the v after it. This is the half
// after a sub-step; in the half before it, the damper acts by the speed at the start of the sub-step, as a known
// impulse. In islands whose contacts see light bodies as heavy, it acts by the speed after it in both halves: else what
// a contact must give would differ from half to half, and the one were no first guess for the other.
// Source: the speed at which a joint is held, as a complementarity problem: Murty, "Linear complementarity",
// 1988.
#pragma once
#include <plumb/dynamics/joints/lanes/island_items_wide.h>

namespace plumb {

template <int W>
struct RowCurve {
    using D = typename Wide<W>::Double;
    using S = Slots<W>;
    using R = RowField;

    static constexpr double unlimited = __builtin_inf();
    static constexpr double notSolved = -1;
    static constexpr D all(double value) { return D{} + value; }

    /// The speed towards a limit that is this far away. Room up to the limit may be used up in one sub-step; a
    /// coordinate beyond it is corrected like any other error.
    static D roomSpeed(D room, const IslandTurn& turn) {
        const D speed = room * turn.rate;
        const D back = turn.correct ? larger(speed, all(-turn.fastest)) : D{};
        return room >= D{} ? speed : back;
    }

    static constexpr double atTarget = 0, atLow = 1, atHigh = 2, atLowerStop = 3, atUpperStop = 4;

    /// Replaces a state from an earlier step that names a stop or a bound of force which the row no longer has.
    static D validState(const S& row, bool bounded) {
        const D state = row[R::LastState], high = row[R::High];
        D valid = state;
        if (bounded) {
            valid = state > all(atHigh) ? all(atTarget) : state;
        } else {
            valid = both(state == all(atLowerStop), row[R::LowerStop] == all(-unlimited)) ? all(atHigh) : valid;
            valid = both(state == all(atUpperStop), row[R::UpperStop] == all(unlimited)) ? all(atLow) : valid;
            valid = both(state == all(atTarget), high <= row[R::Low]) ? all(atLow) : valid;
        }
        return high < all(unlimited) ? valid : all(atTarget);
    }

    /// The part of the curve that has the solution, if the present one has not.
    static D nextState(const S& row, D speed, bool bounded) {
        const D state = row[R::State], high = row[R::High], low = row[R::Low];
        const D aside = row[R::Push] - row[R::Slope] * speed;
        if (bounded) {
            const D below = aside < low ? all(atLow) : all(atTarget);
            return aside > high ? all(atHigh) : below;
        }
        const D impulse = row[R::Impulse] - aside, target = row[R::Target];
        const D fallen = impulse < low ? all(atLow) : state;
        const D fromTarget = impulse > high ? all(atHigh) : fallen;
        const auto isAbove = speed > target, isBelow = speed < target;
        const auto meets = both(high > low, state == all(atHigh) ? isAbove : isBelow);
        const D met = meets ? all(atTarget) : state;
        const D stopped = speed > row[R::UpperStop] ? all(atUpperStop) : met;
        const D fromBound = speed < row[R::LowerStop] ? all(atLowerStop) : stopped;
        const D fromLower = impulse < high ? all(atHigh) : state;
        const D fromUpper = impulse > low ? all(atLow) : state;
        const D atStop = state == all(atLowerStop) ? fromLower : fromUpper;
        const D moved = state < all(atLowerStop) ? fromBound : atStop;
        return state == all(atTarget) ? fromTarget : moved;
    }

    /// The equation v + compliance L = speed of a row, or its known impulse.
    struct Equation {
        D speed, compliance, known;
    };

    static Equation curveEquation(const S& row, bool bounded, double compliance) {
        const D state = row[R::State], push = row[R::Push], slope = row[R::Slope], w = row[R::InverseMass];
        const D rigid = compliance * w, low = row[R::Low], high = row[R::High];
        const auto isSoft = slope > D{};
        const D soft = anyOf<W>(isSoft) ? 1.0 / (isSoft ? slope : all(1)) : D{};
        const D bound = state == all(atHigh) ? high : low;
        if (bounded) {
            const D clamped = state == all(atTarget) ? smaller(larger(push, low), high) : bound;
            const auto solved = both(state == all(atTarget), isSoft);
            return {solved ? push * soft : D{}, solved ? soft : all(notSolved), solved ? D{} : clamped};
        }
        const D pushed = push + bound;
        Equation e{isSoft ? pushed * soft : D{}, isSoft ? soft : all(notSolved), isSoft ? D{} : pushed};
        const auto isRigid = either(state == all(atTarget), state > all(atHigh));
        const D stop = state == all(atLowerStop) ? row[R::LowerStop] : row[R::UpperStop];
        e.speed = isRigid ? (state == all(atTarget) ? row[R::Target] : stop) : e.speed;
        e.compliance = isRigid ? rigid : e.compliance;
        e.known = isRigid ? D{} : e.known;
        return e;
    }
};

}  // namespace plumb
