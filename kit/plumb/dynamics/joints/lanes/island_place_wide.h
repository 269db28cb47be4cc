// SPDX-License-Identifier: MIT
// Where are the bodies, links and rows of W islands, now and after the coming sub-step?
#pragma once
#include <plumb/dynamics/joints/lanes/island_elimination_wide.h>
#include <plumb/dynamics/joints/lanes/island_turn_wide.h>
#include <plumb/math/trig.h>

namespace plumb {

template <int W, LaneUse use>
struct WidePlaces : IslandItems<W, use> {
    using Items = IslandItems<W, use>;
    using D = typename Items::D;
    using S = typename Items::S;
    using BodyAtEnd = typename Items::BodyAtEnd;
    using B = BodyField;
    using L = LinkField;
    using R = RowField;
    using Items::all;
    using Items::bodyOf;
    using Items::endOf;
    using Items::isActive;
    using Items::linkOf;
    using Items::rowOf;

    /// A direction, and its levers about both bodies.
    struct Axis {
        D x, y, turnA, turnB;
    };
    struct Pair {
        D x, y;
    };
    static Pair turned(D cos, D sin, D x, D y) { return {cos * x - sin * y, sin * x + cos * y}; }

    static void move(IslandLanes& v, double h) {
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            b.set(B::X, b[B::X] + b[B::Vx] * h);
            b.set(B::Y, b[B::Y] + b[B::Vy] * h);
            b.set(B::Turn, b[B::Turn] + b[B::Spin] * h);
            for (int c = 0; c < 3; ++c) b.set(B::MovedX + c, b[B::Vx + c]);
        }
        place(v);
    }

    static void turn(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            const D t = b[B::Turn];
            b.set(B::Cos, WideTurn<W>::cosine(t));
            b.set(B::Sin, WideTurn<W>::sine(t));
            if (anyOf<W>(magnitude(t) > all(WideTurn<W>::farthest)))
                WideTurn<W>::far(b.data + B::Cos * S::N, b.data + B::Sin * S::N, b.data + B::Turn * S::N);
        }
    }

    static void place(IslandLanes& v) {
        v.factored = false;
        turn(v);
        for (std::uint32_t i = 0; i < v.linkCount; ++i) placeLink(v, i);
        for (std::uint32_t i = 0; i < v.rowCount; ++i) placeRow(v, i);
    }

    static void placeLink(const IslandLanes& v, std::uint32_t i) {
        const S l = linkOf(v, i);
        const BodyAtEnd a = endOf(v, i, false), b = endOf(v, i, true);
        const D ax = l[L::StartArmAx], ay = l[L::StartArmAy], bx = l[L::StartArmBx], by = l[L::StartArmBy];
        const Pair armA = turned(a[B::Cos], a[B::Sin], ax, ay), armB = turned(b[B::Cos], b[B::Sin], bx, by);
        l.set(L::ArmAx, armA.x);
        l.set(L::ArmAy, armA.y);
        l.set(L::ArmBx, armB.x);
        l.set(L::ArmBy, armB.y);
        l.set(L::ApartX, l[L::StartApartX] + ((b[B::X] - a[B::X]) + ((armB.x - bx) - (armA.x - ax))));
        l.set(L::ApartY, l[L::StartApartY] + ((b[B::Y] - a[B::Y]) + ((armB.y - by) - (armA.y - ay))));
        l.set(L::Angle, l[L::StartAngle] + (b[B::Turn] - a[B::Turn]));
    }

    /// The length of a vector, also of one whose square is too large or too small for a double.
    static D lengthOf(D x, D y) {
        const D most = larger(magnitude(x), magnitude(y));
        const D scale = most > D{} ? most : all(1);
        const D u = x / scale, w = y / scale;
        return scale * squareRoot<W>(u * u + w * w);
    }

    static Pair unit(D x, D y, D otherwise) {
        const D length = lengthOf(x, y);
        const auto some = length > D{};
        const D divisor = some ? length : all(1);
        return {some ? x / divisor : otherwise, some ? y / divisor : D{}};
    }

    /// B's wanted velocity relative to A, less the one without the joints' impulses.
    static Pair missingVelocity(const S& row, const S& l, const BodyAtEnd& a, const BodyAtEnd& b) {
        const D fromX = l[L::ArmAx] + l[L::ApartX], fromY = l[L::ArmAy] + l[L::ApartY];
        const D speedX = (b[B::FreeX] - l[L::ArmBy] * b[B::FreeSpin]) - (a[B::FreeX] - fromY * a[B::FreeSpin]);
        const D speedY = (b[B::FreeY] + l[L::ArmBx] * b[B::FreeSpin]) - (a[B::FreeY] + fromX * a[B::FreeSpin]);
        const Pair wanted = wantedVelocity(row, l, a);
        return {wanted.x - speedX, wanted.y - speedY};
    }
    static Pair wantedVelocity(const S& row, const S& l, const BodyAtEnd& a) {
        const Pair given = turned(a[B::Cos], a[B::Sin], row[R::DirectionX], row[R::DirectionY]);
        return {given.x - l[L::ApartX] * row[R::DriveRate], given.y - l[L::ApartY] * row[R::DriveRate]};
    }

    static Pair directionOf(RowAxis axis, const S& row, int direction, const S& l, const BodyAtEnd& a) {
        const D x = row[direction], y = row[direction + 1];
        switch (axis) {
            case RowAxis::World: return {x, y};
            case RowAxis::OnA: return turned(a[B::Cos], a[B::Sin], x, y);
            case RowAxis::Along: return unit(l[L::ApartX], l[L::ApartY], D{});
            case RowAxis::Towards: return unit(l[L::ApartX], l[L::ApartY], all(1));
            case RowAxis::Across: {
                const Pair towards = unit(l[L::ApartX], l[L::ApartY], all(1));
                return {-towards.y, towards.x};
            }
            default: return {D{}, D{}};
        }
    }

    static Axis axisOf(const IslandLanes& v, std::uint32_t link, RowAxis axis, const S& row, int direction) {
        if (axis == RowAxis::Turning) return {D{}, D{}, all(-1), all(1)};
        const S l = linkOf(v, link);
        const BodyAtEnd a = endOf(v, link, false), b = endOf(v, link, true);
        Pair u = directionOf(axis, row, direction, l, a);
        if (axis == RowAxis::Missing || axis == RowAxis::Beside) {
            const Pair lacked = missingVelocity(row, l, a, b);
            u = unit(lacked.x, lacked.y, all(1));
            if (axis == RowAxis::Beside) u = {-u.y, u.x};
        }
        const D fromX = l[L::ArmAx] + l[L::ApartX], fromY = l[L::ArmAy] + l[L::ApartY];
        return {u.x, u.y, fromY * u.x - fromX * u.y, l[L::ArmBx] * u.y - l[L::ArmBy] * u.x};
    }

    /// A part of the coordinate; later: after the coming sub-step.
    static D coordinateOf(const IslandLanes& v, std::uint32_t link, RowAxis axis, const S& row, int direction,
                          bool later) {
        const S l = linkOf(v, link);
        if (axis == RowAxis::Turning) return l[later ? L::LaterAngle : L::Angle];
        const D x = l[later ? L::LaterApartX : L::ApartX], y = l[later ? L::LaterApartY : L::ApartY];
        if (axis == RowAxis::Along || axis == RowAxis::Towards) return lengthOf(x, y);
        Pair u{row[direction], row[direction + 1]};
        if (axis == RowAxis::OnA) {
            const BodyAtEnd a = endOf(v, link, false);
            u = turned(a[later ? B::LaterCos : B::Cos], a[later ? B::LaterSin : B::Sin], u.x, u.y);
        }
        return axis == RowAxis::World || axis == RowAxis::OnA ? u.x * x + u.y * y : D{};
    }

    static D coordinateOf(const IslandLanes& v, const IslandShape::Row& shape, const S& row, bool later) {
        D q = coordinateOf(v, shape.link, shape.axis[0], row, R::DirectionX, later);
        if (shape.parts > 1)
            q += row[R::Ratio] * coordinateOf(v, shape.link + 1, shape.axis[1], row, R::SecondDirectionX, later);
        return q - row[R::Origin];
    }

    static D inverseMassOf(const IslandLanes& v, std::uint32_t link, const Axis& axis) {
        const BodyAtEnd a = endOf(v, link, false), b = endOf(v, link, true);
        return (axis.x * axis.x + axis.y * axis.y) * (a[B::InverseMass] + b[B::InverseMass]) +
               (axis.turnA * axis.turnA * a[B::InverseInertia] + axis.turnB * axis.turnB * b[B::InverseInertia]);
    }

    static void setAxis(const S& row, int field, const Axis& axis) {
        row.set(field, axis.x);
        row.set(field + 1, axis.y);
        row.set(field + 2, axis.turnA);
        row.set(field + 3, axis.turnB);
    }

    static void placeRow(const IslandLanes& v, std::uint32_t i) {
        const IslandShape::Row& shape = v.rows[i];
        const S row = rowOf(v, i);
        const Axis axis = axisOf(v, shape.link, shape.axis[0], row, R::DirectionX);
        setAxis(row, R::AxisX, axis);
        D w = inverseMassOf(v, shape.link, axis);
        if (shape.parts > 1) {
            const D ratio = row[R::Ratio];
            Axis second = axisOf(v, shape.link + 1, shape.axis[1], row, R::SecondDirectionX);
            second = {second.x * ratio, second.y * ratio, second.turnA * ratio, second.turnB * ratio};
            setAxis(row, R::SecondAxisX, second);
            w += inverseMassOf(v, shape.link + 1, second);
        }
        row.set(R::InverseMass, w);
        row.set(R::Coordinate, coordinateOf(v, shape, row, false));
        if (shape.holds)
            row.set(R::Compliance, w > D{} ? v.compliance * w : all(-1));
        else
            findGrowth(row, w);
    }

    /// exp(c w h / 2) - 1, found anew only where it has changed.
    static void findGrowth(const S& row, D w) {
        const D damped = row[R::HalfDamping] * w;
        if (!anyOf<W>(damped != row[R::DampedAt])) return;
        // A larger value removes all of the speed; a smaller one removes nothing, and its inverse would be too large.
        constexpr double least = 1e-16, most = 30;
        row.set(R::DampedAt, damped);
        for (int l = 0; l < Wide<W>::doubles; ++l) {
            const double at = row.data[R::DampedAt * S::N + l];
            row.data[R::Growth * S::N + l] = at > least ? exponentialMinus1(at < most ? at : most) : 0;
        }
    }

    static void noteSpeeds(const IslandLanes& v, bool hold) {
        for (std::uint32_t i = 0; i < v.rowCount; ++i)
            if (v.rows[i].holds == hold)
                rowOf(v, i).set(R::NotedSpeed, Elimination<W, use>::speedOf(v, i, B::Vx, B::Spin));
    }

    /// Turning is predicted up to half a radian only: at larger angles, in a joint that is coming apart, the prediction
    /// would add to the error.
    template <class Body>
    static D spinAhead(const Body& b, double h) {
        const D most = all(0.5 / h);
        return smaller(larger(b[B::Uspin], -most), most);
    }

    /// Where bodies will be after the coming sub-step at the velocities U, where lanes are active.
    static void predict(const IslandLanes& v, double h) {
        const auto active = isActive(v);
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            const D spin = spinAhead(b, h), t = spin * h;
            const D cos = WideTurn<W>::cosine(t), sin = WideTurn<W>::sine(t);
            const Pair r = turned(cos, sin, b[B::Cos], b[B::Sin]);
            b.set(B::AheadSpin, active ? spin : b[B::AheadSpin]);
            b.set(B::LaterCos, active ? r.x : b[B::LaterCos]);
            b.set(B::LaterSin, active ? r.y : b[B::LaterSin]);
            b.set(B::LaterX, active ? b[B::X] + b[B::Ux] * h : b[B::LaterX]);
            b.set(B::LaterY, active ? b[B::Y] + b[B::Uy] * h : b[B::LaterY]);
        }
        for (std::uint32_t i = 0; i < v.linkCount; ++i) predictLink(v, i, h);
    }

    static void predictLink(const IslandLanes& v, std::uint32_t i, double h) {
        const S l = linkOf(v, i);
        const BodyAtEnd a = endOf(v, i, false), b = endOf(v, i, true);
        const D ax = l[L::StartArmAx], ay = l[L::StartArmAy], bx = l[L::StartArmBx], by = l[L::StartArmBy];
        const Pair armA = turned(a[B::LaterCos], a[B::LaterSin], ax, ay);
        const Pair armB = turned(b[B::LaterCos], b[B::LaterSin], bx, by);
        l.set(L::LaterApartX, l[L::StartApartX] + ((b[B::LaterX] - a[B::LaterX]) + ((armB.x - bx) - (armA.x - ax))));
        l.set(L::LaterApartY, l[L::StartApartY] + ((b[B::LaterY] - a[B::LaterY]) + ((armB.y - by) - (armA.y - ay))));
        l.set(L::LaterAngle, l[L::Angle] + (b[B::AheadSpin] - a[B::AheadSpin]) * h);
    }

    /// Rows were predicted from velocities that are not U any more. The error of that, in parts of a link, is by how
    /// much more a body or a rod turns in the coming sub-step than was predicted, times how far it turns. Where it is
    /// too large, lanes stay active; where it has not become much smaller since the last call, they are lost. Returns
    /// true if some are active.
    static bool keepMissed(const IslandLanes& v, double h) {
        constexpr double small = 1e-6, smaller = 0.5;
        D worst{};
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            const D spin = spinAhead(b, h);
            worst = larger(worst, magnitude((spin - b[B::AheadSpin]) * spin) * (h * h));
        }
        for (std::uint32_t i = 0; i < v.linkCount; ++i)
            if (v.links[i].turnsAlong) worst = larger(worst, missedAlong(v, i, h));
        worst = Items::largestOfIsland(worst);
        const auto missing = both(isActive(v), worst > all(small));
        const auto closer = worst < smaller * Items::ofIsland(v.missed);
        const D lost = missing ? (closer ? D{} : all(1)) : Items::ofIsland(v.lost);
        const D active = missing ? (closer ? all(1) : D{}) : D{};
        Items::keepOfIsland(v.missed, worst);
        Items::keepOfIsland(v.lost, lost);
        Items::keepOfIsland(v.active, active);
        return anyOf<W>(active > D{});
    }

    static D missedAlong(const IslandLanes& v, std::uint32_t i, double h) {
        const S l = linkOf(v, i);
        const BodyAtEnd a = endOf(v, i, false), b = endOf(v, i, true);
        const D turnA = (spinAhead(a, h) - a[B::AheadSpin]) * h, turnB = (spinAhead(b, h) - b[B::AheadSpin]) * h;
        const auto ahead = [&](int c) {
            return (b[B::X + c] + b[B::Ux + c] * h - b[B::LaterX + c]) -
                   (a[B::X + c] + a[B::Ux + c] * h - a[B::LaterX + c]);
        };
        const D x = ahead(0) - (l[L::ArmBy] * turnB - (l[L::ArmAy] + l[L::ApartY]) * turnA);
        const D y = ahead(1) + (l[L::ArmBx] * turnB - (l[L::ArmAx] + l[L::ApartX]) * turnA);
        const D movedX = l[L::LaterApartX] - l[L::ApartX] + x, movedY = l[L::LaterApartY] - l[L::ApartY] + y;
        const D length = l[L::ApartX] * l[L::ApartX] + l[L::ApartY] * l[L::ApartY];
        const auto some = length > D{};
        const D missed = (magnitude(x) + magnitude(y)) * (magnitude(movedX) + magnitude(movedY));
        return some ? missed / (some ? length : all(1)) : D{};
    }
};

}  // namespace plumb
