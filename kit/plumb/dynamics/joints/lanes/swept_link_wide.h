// SPDX-License-Identifier: MIT
// Where are the bodies of W joints that are swept, and how do rows act on them? As in island_place_wide.h, in floats.
#pragma once
#include <plumb/dynamics/joints/lanes/island_shape.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct SweptLink {
    using F = typename Wide<W>::Float;

    struct Pair {
        F x, y;
    };
    /// A direction, and its levers about both bodies.
    struct Axis {
        F x, y, turnA, turnB;
    };

    Rows<W> va, vb;
    F rhoA, rhoB;      ///< inverse radii of gyration
    Pair a, b, apart;  ///< arms and gap now
    F cosMinus1, sin;  ///< of the angle that A has turned in this step
    F angle;           ///< that B has turned more than A

    static constexpr F of(float value) { return F{} + value; }
    static Pair turned(F cosMinus1, F sin, F x, F y) {
        return {x + (x * cosMinus1 - y * sin), y + (y * cosMinus1 + x * sin)};
    }
    static F dot(const Axis& axis, const Pair& p) { return axis.x * p.x + axis.y * p.y; }

    Axis axisAt(const Pair& u) const { return {u.x, u.y, fromA().y * u.x - fromA().x * u.y, b.x * u.y - b.y * u.x}; }
    Pair fromA() const { return {a.x + apart.x, a.y + apart.y}; }
    static Pair unit(const Pair& p, float otherwise) {
        const F length = squareRoot<W>(p.x * p.x + p.y * p.y);
        const auto some = length > F{};
        const F divisor = some ? length : of(1);
        return {some ? p.x / divisor : of(otherwise), some ? p.y / divisor : F{}};
    }
    /// start: the direction at the step's start, of an axis that turns with A.
    Axis axisOf(RowAxis axis, bool alongY, const Pair& start) const {
        if (axis == RowAxis::Turning) return {F{}, F{}, of(-1), of(1)};
        if (axis == RowAxis::World && !alongY) return {of(1), F{}, a.y, -b.y};
        if (axis == RowAxis::World) return {F{}, of(1), -a.x, b.x};
        if (axis == RowAxis::OnA) return axisAt(turned(cosMinus1, sin, start.x, start.y));
        const Pair u = unit(apart, axis == RowAxis::Along ? 0 : 1);
        return axisAt(axis == RowAxis::Across ? Pair{-u.y, u.x} : u);
    }
    F coordinateOf(RowAxis axis, const Axis& u) const {
        if (axis == RowAxis::Turning) return angle;
        return axis == RowAxis::Across ? F{} : dot(u, apart);
    }

    /// What a unit impulse along one axis of a link changes of the speed along another.
    F inverseMass(const Axis& u, const Axis& w) const {
        const F byA = va.w * (rhoA * rhoA) * (u.turnA * w.turnA), byB = vb.w * (rhoB * rhoB) * (u.turnB * w.turnB);
        return (u.x * w.x + u.y * w.y) * (va.w + vb.w) + (byA + byB);
    }
    /// By how much a part of a row bends away in the coming sub-step, to second order, divided by h. Turning is limited
    /// to a tenth of a radian: at larger angles, in a joint that is coming apart, the term would add to the error that
    /// it should correct.
    F bendOf(RowAxis axis, const Axis& u, F h) const {
        if (axis == RowAxis::Turning) return F{};
        const F most = of(0.1f);
        const F spinA = va.z * rhoA, spinB = vb.z * rhoB;
        const F turn = smaller(larger(spinA * h, -most), most), turnB = smaller(magnitude(spinB * h), most);
        const F bendA = 0.5f * turn * turn / h, bendB = 0.5f * turnB * turnB / h;
        const F bend = dot(u, {b.x * bendB - a.x * bendA, b.y * bendB - a.y * bendA});
        if (axis == RowAxis::World) return bend;
        const Pair speed{(vb.x - b.y * spinB) - (va.x - a.y * spinA), (vb.y + b.x * spinB) - (va.y + a.x * spinA)};
        const F aside = u.x * speed.y - u.y * speed.x, length = dot(u, apart);
        if (axis == RowAxis::OnA) return bend + length * bendA - turn * aside;
        const F along = smaller(magnitude(aside * h), length * most);
        return bend - (length > F{} ? 0.5f * along * along / ((length > F{} ? length : of(1)) * h) : F{});
    }
};

}  // namespace plumb
