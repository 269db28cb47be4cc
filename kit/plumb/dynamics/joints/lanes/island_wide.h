// SPDX-License-Identifier: MIT
// Which conditions do the rows of W islands set? See island_curve_wide.h.
#pragma once
#include <plumb/dynamics/joints/lanes/island_curve_wide.h>
#include <plumb/dynamics/joints/lanes/island_elimination_wide.h>
#include <plumb/dynamics/joints/lanes/island_place_wide.h>
#include <plumb/dynamics/joints/lanes/island_response_wide.h>
#include <plumb/dynamics/joints/lanes/island_stiffness_wide.h>

namespace plumb {

template <int W, LaneUse use>
struct WideIslands : IslandItems<W, use> {
    using Items = IslandItems<W, use>;
    using D = typename Items::D;
    using S = typename Items::S;
    using B = BodyField;
    using L = LinkField;
    using R = RowField;
    using Curve = RowCurve<W>;
    using Places = WidePlaces<W, use>;
    using Equations = Elimination<W, use>;
    using Items::all;
    using Items::bodyOf;
    using Items::isActive;
    using Items::linkOf;
    using Items::rowOf;

    static void kick(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            const D share = b[B::OwnMass] / b[B::Mass];  // what is added to a mass has no weight
            b.set(B::FreeX, b[B::Vx] * b[B::KeepLinear] + b[B::GainX] * share);
            b.set(B::FreeY, b[B::Vy] * b[B::KeepLinear] + b[B::GainY] * share);
            b.set(B::FreeSpin, b[B::Spin] * b[B::KeepAngular] + b[B::GainSpin]);
        }
    }

    static void guess(const IslandLanes& v, double share) {
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            for (int c = 0; c < 3; ++c) b.set(B::Ux + c, b[B::Vx + c] + (b[B::Vx + c] - b[B::MovedX + c]) * share);
        }
    }

    static void prepare(IslandLanes& v, const IslandTurn& turn) {
        if (turn.closesGaps()) Places::predict(v, turn.h);
        for (std::uint32_t i = 0; i < v.rowCount; ++i) {
            const IslandShape::Row& shape = v.rows[i];
            if (shape.axis[0] == RowAxis::Missing || shape.axis[0] == RowAxis::Beside) {
                v.factored = false;
                Places::placeRow(v, i);
            }
            const S row = rowOf(v, i);
            D bend{};
            if (turn.closesGaps()) bend = bendOf(v, i, turn);
            if (shape.holds)
                holdRow(v, row, heldSpeed(row, bend, turn));
            else
                driveRow(v, shape, row, bend, turn);
        }
    }

    /// By how much a row's predicted motion differs from its speed.
    static D bendOf(const IslandLanes& v, std::uint32_t i, const IslandTurn& turn) {
        const S row = rowOf(v, i);
        return Equations::speedOf(v, i, B::Ux, B::AheadSpin) -
               (Places::coordinateOf(v, v.rows[i], row, true) - row[R::Coordinate]) * turn.rate;
    }

    static bool predictAgain(IslandLanes& v, const IslandTurn& turn) {
        if (!Places::keepMissed(v, turn.h)) return false;
        predictHeld(v, turn, true);
        return true;
    }

    static void predictHeld(const IslandLanes& v, const IslandTurn& turn, bool bends) {
        if (bends) Places::predict(v, turn.h);
        for (std::uint32_t i = 0; i < v.rowCount; ++i)
            if (v.rows[i].holds)
                holdRow(v, rowOf(v, i), heldSpeed(rowOf(v, i), bends ? bendOf(v, i, turn) : D{}, turn));
    }

    /// Removes the present error, and the whole error that the sub-step would add, to any order.
    static D heldSpeed(const S& row, D bend, const IslandTurn& turn) {
        if (!turn.closesGaps()) return D{};
        const D back = row[R::Coordinate] * turn.rate;
        return bend - smaller(larger(back, all(-turn.fastest)), all(turn.fastest));
    }
    /// Where a lane is active. Others keep what they want.
    static void holdRow(const IslandLanes& v, const S& row, D speed) {
        row.set(R::Speed, isActive(v) ? speed : row[R::Speed]);
    }

    static void driveRow(const IslandLanes& v, const IslandShape::Row& shape, const S& row, D bend,
                         const IslandTurn& turn) {
        const D q = row[R::Coordinate], w = row[R::InverseMass];
        const D high = turn.onlyHold ? D{} : row[R::MostImpulse];
        row.set(R::High, high);
        row.set(R::Low, -high);
        D target = row[R::DriveSpeed] - row[R::DriveRate] * q;
        if (shape.axis[0] == RowAxis::Missing || shape.axis[0] == RowAxis::Beside) {
            const auto wanted = Places::wantedVelocity(row, linkOf(v, shape.link), Items::endOf(v, shape.link, false));
            target = row[R::AxisX] * wanted.x + row[R::AxisY] * wanted.y;
        }
        const D above = Curve::roomSpeed(row[R::LimitUpper] - q, turn);
        const D below = Curve::roomSpeed(q - row[R::LimitLower], turn);
        const D upper = bend + above, lower = smaller(bend - below, upper);
        row.set(R::Back, smaller(above, D{}) - smaller(below, D{}));
        row.set(R::UpperStop, upper);
        row.set(R::LowerStop, lower);
        row.set(R::Target, smaller(larger(target, lower), upper));
        const D push = turn.onlyHold ? D{} : -row[R::HalfStiffness] * (q - row[R::SpringRest]), growth = row[R::Growth];
        D slope{}, dampPush{};
        if (!turn.onlyHold && anyOf<W>(growth > D{})) {
            const auto movable = w > D{};
            const D divisor = movable ? w : all(1);
            const auto isEarly = both(movable, Items::ofIsland(v.heavy) == D{});
            const D early = isEarly ? -growth / (1.0 + growth) / divisor * row[R::NotedSpeed] : D{};
            const D late = movable ? growth / divisor : D{};
            if (turn.correct && !shape.bounded) {
                dampPush = early;
                slope = isEarly ? D{} : late;
            } else {
                slope = late;
            }
        }
        row.set(R::Wanted, target);
        row.set(R::TakenBack, takenBack(v, row, turn));
        row.set(R::DampPush, dampPush);
        row.set(R::Push, push + dampPush - row[R::TakenBack]);
        row.set(R::Slope, slope);
        row.set(R::State, Curve::validState(row, shape.bounded));
    }

    /// The half that does not correct takes back what stops gave to close errors: it would else be speed for good.
    /// Pieces of a sub-step have halves of their own.
    static D takenBack(const IslandLanes& v, const S& row, const IslandTurn& turn) {
        const D given = row[R::StopPush];
        if (turn.correct != turn.onlyHold) row.set(R::StopPush, isActive(v) ? D{} : given);
        return turn.correct ? D{} : given;
    }

    /// Returns true if some row came to another part of its curve.
    static bool changeStates(const IslandLanes& v) {
        const auto active = isActive(v);
        bool changed = false;
        for (std::uint32_t i = 0; i < v.rowCount; ++i) {
            if (v.rows[i].holds) continue;
            const S row = rowOf(v, i);
            const D next = Curve::nextState(row, Equations::speedOf(v, i, B::Ux, B::Uspin), v.rows[i].bounded);
            const D state = row[R::State], now = active ? next : state;
            changed = changed || anyOf<W>(now != state);
            row.set(R::State, now);
        }
        return changed;
    }

    static void setEquation(IslandLanes& v, const S& row, D speed, D compliance, D known) {
        compliance =
            row[R::InverseMass] > D{} ? compliance : all(Curve::notSolved);  // else the row cannot move anything
        v.factored = v.factored && !anyOf<W>(compliance != row[R::Compliance]);
        row.set(R::Compliance, compliance);
        row.set(R::Speed, speed);
        row.set(R::Known, known);
    }

    /// Those of rows that hold are known when they are placed, and their speeds when they are predicted.
    static void findEquations(IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.rowCount && v.someFree; ++i) {
            if (v.rows[i].holds) continue;
            const S row = rowOf(v, i);
            const auto e = Curve::curveEquation(row, v.rows[i].bounded, v.compliance);
            setEquation(v, row, e.speed, e.compliance, e.known);
        }
    }

    static bool solve(IslandLanes& v) {
        constexpr int mostTurns = 8;  // after these, rows keep their states until the next pass
        bool changed = false;
        for (int turn = 0; turn < mostTurns; ++turn) {
            findEquations(v);
            Equations::start(v);
            Equations::applyKnown(v);
            Equations::solve(v);
            if (!v.someFree || turn + 1 == mostTurns || !changeStates(v)) break;
            changed = true;
        }
        return changed;
    }

    /// Rows keep their present speeds: J U = J V. Rows that do not hold and are not at a stop give nothing.
    static void solvePush(IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.rowCount; ++i) {
            const S row = rowOf(v, i);
            const D speed = Equations::speedOf(v, i, B::Vx, B::Spin);
            holdRow(v, row, speed);
            if (v.rows[i].holds) continue;
            const D rigid = v.compliance * row[R::InverseMass];
            const D compliance = row[R::State] > all(Curve::atHigh) ? rigid : all(Curve::notSolved);
            setEquation(v, row, speed, compliance, D{});
        }
        Equations::solve(v);
    }

    static void findResponses(IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.rowCount && v.someFree; ++i) {
            if (v.rows[i].holds) continue;
            const S row = rowOf(v, i);
            const D rigid = v.compliance * row[R::InverseMass], slope = row[R::Slope];
            const auto isSoft = slope > D{};
            const D soft = isSoft ? 1.0 / (isSoft ? slope : all(1)) : all(Curve::notSolved);
            setEquation(v, row, D{}, row[R::Loaded] > D{} ? rigid : soft, D{});
        }
        Response<W, use>::find(v);
    }

    static void accept(const IslandLanes& v) {
        const auto active = isActive(v);
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            b.set(B::Vx, active ? b[B::Ux] : b[B::Vx]);
            b.set(B::Vy, active ? b[B::Uy] : b[B::Vy]);
            b.set(B::Spin, active ? b[B::Uspin] : b[B::Spin]);
        }
        D back{};
        for (std::uint32_t i = 0; i < v.rowCount && v.someFree; ++i)
            if (!v.rows[i].holds) back = larger(back, magnitude(rowOf(v, i)[R::Back]));
        back = active ? Items::largestOfIsland(back) : D{};
        if (!anyOf<W>(back > D{})) return;
        for (std::uint32_t i = 0; i < v.rowCount; ++i)
            if (!v.rows[i].holds) addStopPush(v, rowOf(v, i), i, back);
    }

    /// Of what a stop gives, the fastest way back to a stop in the island, as a share of the speed that this stop
    /// changes, closes errors: one that pulls others along has no error of its own. A drive that presses against the
    /// stop gives nothing.
    static void addStopPush(const IslandLanes& v, const S& row, std::uint32_t i, D back) {
        const D state = row[R::State], wanted = row[R::Wanted], high = row[R::High];
        const auto isLow = wanted<row[R::LowerStop], isHigh = wanted> row[R::UpperStop];
        const D pressed = isLow ? all(1) : (isHigh ? all(-1) : D{});
        const D atTarget = state == all(Curve::atTarget) ? pressed : D{};
        const D upper = state == all(Curve::atUpperStop) ? all(-1) : atTarget;
        const D sign = state == all(Curve::atLowerStop) ? all(1) : upper;
        const D aside = row[R::Push] - row[R::Slope] * Equations::speedOf(v, i, B::Ux, B::Uspin);
        const D given = larger(sign * (row[R::Impulse] - aside) - (sign == pressed ? D{} : high), D{});
        const D change =
            (sign > D{} ? row[R::LowerStop] : row[R::UpperStop]) - Equations::speedOf(v, i, B::FreeX, B::FreeSpin);
        const auto counts = both(both(back > D{}, sign != D{}), high < all(Curve::unlimited));
        const D share = counts ? back / (counts ? larger(sign * change, back) : all(1)) : D{};
        row.set(R::StopPush, row[R::StopPush] + (counts ? sign * given * share : D{}));
    }

    static void addLoads(const IslandLanes& v) {
        const auto active = isActive(v);
        for (std::uint32_t j = 0; j < v.jointCount; ++j) {
            const S joint{v.joint + j * std::size_t{JointField::count} * S::N};
            for (std::uint32_t i = v.joints[j].firstRow; i < v.joints[j + 1].firstRow; ++i)
                addLoad(v, joint, i, v.joints[j].turnsOnly, active);
        }
    }

    template <class M>
    static void addLoad(const IslandLanes& v, const S& joint, std::uint32_t i, bool turnsOnly, const M& active) {
        const S row = rowOf(v, i);
        const int axis = v.rows[i].parts > 1 ? R::SecondAxisX : R::AxisX;
        const D impulse = active ? row[R::Impulse] : D{}, x = row[axis] * impulse, y = row[axis + 1] * impulse;
        D lever = row[axis + 3] * impulse;
        if (!turnsOnly) {
            const S l = linkOf(v, v.rows[i].link + (v.rows[i].parts - 1));
            lever -= l[L::ArmBx] * y - l[L::ArmBy] * x;
        }
        joint.set(JointField::LoadX, joint[JointField::LoadX] + x);
        joint.set(JointField::LoadY, joint[JointField::LoadY] + y);
        joint.set(JointField::LoadTurn, joint[JointField::LoadTurn] + lever);
    }
};

template <int W, LaneUse use>
const IslandKernel WideIslandKernel<W, use>::code{
    WidePlaces<W, use>::move,           WidePlaces<W, use>::place,          WidePlaces<W, use>::noteSpeeds,
    WideIslands<W, use>::guess,         WideIslands<W, use>::prepare,       WideIslands<W, use>::predictAgain,
    WideIslands<W, use>::predictHeld,   WideIslands<W, use>::solve,         WideIslands<W, use>::solvePush,
    WideIslands<W, use>::findResponses, WideIslands<W, use>::accept,        WideIslands<W, use>::addLoads,
    Elimination<W, use>::findWork,      WideStiffness<W, use>::noteForces,  WideStiffness<W, use>::setMasses,
    WideIslands<W, use>::kick,          WideStiffness<W, use>::findInertias};

}  // namespace plumb
