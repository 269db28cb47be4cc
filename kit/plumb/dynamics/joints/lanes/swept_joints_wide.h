// SPDX-License-Identifier: MIT
// How are W joints of a swept island solved at once?
//
// First the rows that do not hold, each by itself; then those that hold, as one block. With K the effective inverse
// masses, from impulses L to the rows' speeds v, and L0 the impulses so far:
//   before a sub-step h   K L = -s (v + b q - e) - i L0,   after it   K L = -v,   and L + L0 are the impulses from then
//   on
// q coordinates [m or rad], e by how much the rows bend away in the sub-step, divided by h; b, s, i bias rate, mass
// scale and impulse scale (see softness.h). A row that does not hold gives the impulse of its curve (see
// island_curve_wide.h), found from v0, its speed without its own impulse. Joints are so soft only before a sub-step.
#pragma once
#include <plumb/collide/lanes/relative_lanes.h>
#include <plumb/dynamics/joints/lanes/swept_lanes.h>
#include <plumb/dynamics/joints/lanes/swept_link_wide.h>

namespace plumb {

/// AllHinges: all joints are plain hinges, of two rows that hold. Then the compiler knows the shape.
template <int W, bool AllHinges>
struct SweptLanes {
    using F = typename Wide<W>::Float;
    using N = SweptField;
    using Link = SweptLink<W>;
    using Pair = typename Link::Pair;
    using Axis = typename Link::Axis;

    struct Row {
        Axis axis, second;
        F old, coordinate;
    };

    const SweptForm& shape;             ///< if AllHinges, plainHinge, which the compiler knows
    float* const fields;                ///< of these lanes
    const std::uint32_t* const bodies;  ///< of these lanes
    const SolverBodies& all;
    const SweptPass& pass;
    Link link[2] = {};
    Row row[3] = {};

    static constexpr F of(float value) { return F{} + value; }
    F at(int field) const { return loadLanes<W>(static_cast<const float*>(fields) + field * batchLanes); }
    void set(int field, F value) const { storeLanes(fields + field * batchLanes, value); }
    const std::uint32_t* slots(int k, bool isB) const { return bodies + (2 * k + (isB ? 1 : 0)) * batchLanes; }
    auto signedSlots(int k, bool isB) const {
        return loadLanes<W>(reinterpret_cast<const std::int32_t*>(slots(k, isB)));
    }
    /// Calls act(r) for each row.
    template <class Act>
    void forRows(Act&& act) const {
        act(0);
        if (shape.rows > 1) act(1);
        if (shape.rows > 2) act(2);
    }
    bool isMissing(int r) const { return !AllHinges && shape.axis[r] == RowAxis::Missing; }
    bool isTwofold() const { return !AllHinges && shape.links > 1; }
    void load(int k) {
        Link& l = link[k];
        const int first = N::joint + k * N::link;
        l.va = loadRows<W>(&all.velocity->x, slots(k, false));
        l.vb = loadRows<W>(&all.velocity->x, slots(k, true));
        l.rhoA = at(first + N::InverseGyrationA);
        l.rhoB = at(first + N::InverseGyrationB);
        if (pass.hasMoved && pass.isFirstGuess) findPlace(k);
        l.a = {at(first + N::NowAx), at(first + N::NowAy)};
        l.b = {at(first + N::NowBx), at(first + N::NowBy)};
        l.apart = {at(first + N::NowApartX), at(first + N::NowApartY)};
        if constexpr (AllHinges) return;
        l.cosMinus1 = at(first + N::CosMinus1);
        l.sin = at(first + N::Sin);
        l.angle = at(first + N::Angle);
    }
    /// Once for all passes between two moves.
    void findPlace(int k) {
        Link l = link[k];
        const int first = N::joint + k * N::link;
        const Rows<W> da = loadRows<W>(&all.displacement->x, slots(k, false));
        const Rows<W> db = loadRows<W>(&all.displacement->x, slots(k, true));
        l.sin = da.z * l.rhoA;
        l.cosMinus1 = da.w * l.rhoA;
        const F ax = at(first + N::ArmAx), ay = at(first + N::ArmAy);
        const F bx = at(first + N::ArmBx), by = at(first + N::ArmBy);
        l.a = Link::turned(l.cosMinus1, l.sin, ax, ay);
        l.b = Link::turned(db.w * l.rhoB, db.z * l.rhoB, bx, by);
        l.apart = {at(first + N::ApartX) + ((db.x - da.x) + ((l.b.x - bx) - (l.a.x - ax))),
                   at(first + N::ApartY) + ((db.y - da.y) + ((l.b.y - by) - (l.a.y - ay)))};
        const F now[] = {l.a.x, l.a.y, l.b.x, l.b.y, l.apart.x, l.apart.y};
        for (int i = 0; i < 6; ++i) set(first + N::NowAx + i, now[i]);
        if constexpr (AllHinges) return;
        set(first + N::CosMinus1, l.cosMinus1);
        set(first + N::Sin, l.sin);
        set(first + N::Angle,
            loadRows<W>(&all.turn->angle, slots(k, true)).x - loadRows<W>(&all.turn->angle, slots(k, false)).x);
    }
    void store(int k) const {
        storeRows<W>(&all.velocity->x, slots(k, false), link[k].va);
        storeRows<W>(&all.velocity->x, slots(k, true), link[k].vb);
    }

    /// The speed of a row's part. Only a plain hinge's levers need no products with its direction.
    F speedOf(const Link& l, int r, const Axis& u) const {
        const F turn = u.turnA * (l.va.z * l.rhoA) + u.turnB * (l.vb.z * l.rhoB);
        if (AllHinges) return (shape.alongY[r] ? l.vb.y - l.va.y : l.vb.x - l.va.x) + turn;
        return u.x * (l.vb.x - l.va.x) + u.y * (l.vb.y - l.va.y) + turn;
    }
    void push(Link& l, int r, const Axis& u, F impulse) const {
        const F a = l.va.w * impulse, b = l.vb.w * impulse;
        const bool isX = AllHinges && !shape.alongY[r], isY = AllHinges && shape.alongY[r];
        if (!isY) l.va.x -= isX ? a : a * u.x;
        if (!isY) l.vb.x += isX ? b : b * u.x;
        if (!isX) l.va.y -= isY ? a : a * u.y;
        if (!isX) l.vb.y += isY ? b : b * u.y;
        l.va.z += a * l.rhoA * u.turnA;
        l.vb.z += b * l.rhoB * u.turnB;
    }
    /// What the links of a joint add by bodies that they share.
    F sharedInverseMass(const Axis& u, const Axis& w) const {
        const Link& l = link[0];
        const F along = u.x * w.x + u.y * w.y;
        const auto shared = [&](bool isB, bool isSecondB, F mass, F rho, F straight, F turns) {
            const auto same = signedSlots(0, isB) == signedSlots(1, isSecondB);
            return same ? 2.0f * mass * (straight + rho * rho * turns) : F{};
        };
        return shared(false, false, l.va.w, l.rhoA, along, u.turnA * w.turnA) +
               shared(false, true, l.va.w, l.rhoA, -along, u.turnA * w.turnB) +
               shared(true, false, l.vb.w, l.rhoB, -along, u.turnB * w.turnA) +
               shared(true, true, l.vb.w, l.rhoB, along, u.turnB * w.turnB);
    }

    Pair startOf(RowAxis axis, int field) const {
        return axis == RowAxis::OnA ? Pair{at(field), at(field + 1)} : Pair{F{}, F{}};
    }
    void placeRow(int r) {
        Row& p = row[r];
        p.old = at(N::Impulse + r);
        const int first = shape.first[r];
        if (!AllHinges && shape.axis[r] >= RowAxis::Missing && shape.axis[r] != RowAxis::Turning) {
            // Its impulse is kept along x, and that of the next row along y: its axis changes from half to half.
            p.axis = link[0].axisAt(isMissing(r) ? Pair{of(1), F{}} : Pair{F{}, of(1)});
            return;
        }
        p.axis = link[0].axisOf(shape.axis[r], shape.alongY[r], startOf(shape.axis[r], first + N::StartX));
        p.coordinate = AllHinges ? (shape.alongY[r] ? link[0].apart.y : link[0].apart.x)
                                 : link[0].coordinateOf(shape.axis[r], p.axis);
        if (!AllHinges && first > 0) p.coordinate -= at(first + N::Origin);
        if (!isTwofold()) return;
        const Pair start = startOf(shape.secondAxis, first + N::SecondStartX);
        p.second = link[1].axisOf(shape.secondAxis, shape.secondAlongY, start);
        const F ratio = at(first + N::Ratio);
        p.coordinate += ratio * link[1].coordinateOf(shape.secondAxis, p.second);
        p.second = {p.second.x * ratio, p.second.y * ratio, p.second.turnA * ratio, p.second.turnB * ratio};
    }

    F bendOf(int r) const {
        if (!pass.correct) return F{};
        const F bend = link[0].bendOf(shape.axis[r], row[r].axis, of(pass.h));
        return isTwofold() ? bend + link[1].bendOf(shape.secondAxis, row[r].second, of(pass.h)) : bend;
    }
    F speed(int r) const {
        F sum = speedOf(link[0], r, row[r].axis);
        if (isTwofold()) sum += speedOf(link[1], r, row[r].second);
        return sum;
    }
    F inverseMass(int r) const {
        F sum = link[0].inverseMass(row[r].axis, row[r].axis);
        if (isTwofold())
            sum += link[1].inverseMass(row[r].second, row[r].second) + sharedInverseMass(row[r].axis, row[r].second);
        return sum;
    }
    /// The two links of a joint may share a body, so its velocity is stored before the second one changes it.
    void push(int r, F impulse) {
        push(link[0], r, row[r].axis, impulse);
        if (!isTwofold()) return;
        store(0);
        link[1].va = loadRows<W>(&all.velocity->x, slots(1, false));
        link[1].vb = loadRows<W>(&all.velocity->x, slots(1, true));
        push(link[1], r, row[r].second, impulse);
    }

    void start() {
        load(0);
        if (isTwofold()) load(1);
        forRows([&](int r) { placeRow(r); });
    }
    /// Applies the impulses of the last half as a first guess.
    void warm() {
        start();
        forRows([&](int r) { push(r, row[r].old); });
        store(isTwofold() ? 1 : 0);
    }

    /// B's wanted velocity relative to A.
    Pair wantedOf(int first) const {
        const F rate = at(first + N::Rate);
        const Pair given = Link::turned(link[0].cosMinus1, link[0].sin, at(first + N::StartX), at(first + N::StartY));
        return {given.x - link[0].apart.x * rate, given.y - link[0].apart.y * rate};
    }
    /// Takes back the impulses of the first two rows, and lays them along the velocity that B lacks then, and beside
    /// it.
    void turnToMissing() {
        push(0, -row[0].old);
        push(1, -row[1].old);
        const Pair wanted = wantedOf(shape.first[0]);
        const Pair u = Link::unit({wanted.x - speed(0), wanted.y - speed(1)}, 1);
        row[0].axis = link[0].axisAt(u);
        row[1].axis = link[0].axisAt({-u.y, u.x});
        row[0].old = row[1].old = F{};
    }

    /// The speed towards a limit that is this far away (see RowCurve).
    F roomSpeed(F room) const {
        const F back = pass.correct ? larger(room * pass.soft.biasRate, of(-pass.fastest)) : F{};
        return room >= F{} ? room / pass.h : back;
    }

    void drive(int r) {
        Row& p = row[r];
        const int first = shape.first[r];
        const F w = inverseMass(r), before = speed(r), q = p.coordinate;
        const auto movable = w > F{};
        const F divisor = movable ? w : of(1), v0 = before - w * p.old, half = of(0.5f * pass.h);
        // exp(c w h / 2) - 1; its third-order series decays as surely.
        const F damped = smaller(at(first + N::Damping) * half * w, of(30));
        const F growth = damped * (1.0f + damped * (0.5f + damped * (1.0f / 6)));
        const F pushed = -at(first + N::Stiffness) * half * (q - at(first + N::SpringRest));
        const F high = at(first + N::MostForce) * half, share = 1.0f / (1.0f + growth);
        F u = (v0 + w * pushed) * share, impulse;
        if (shape.bounded[r]) {
            impulse = smaller(larger((u - v0) / divisor, -high), high);
        } else {
            const F bend = bendOf(r);
            F target = at(first + N::Speed) - at(first + N::Rate) * q;
            if (isMissing(r) || shape.axis[r] == RowAxis::Beside) target = Link::dot(p.axis, wantedOf(first));
            const F upper = bend + roomSpeed(at(first + N::Upper) - q);
            const F lower = smaller(bend - roomSpeed(q - at(first + N::Lower)), upper);
            target = smaller(larger(target, lower), upper);
            u += smaller(larger((target - u) * (1.0f + growth) / divisor, -high), high) * w * share;
            const auto isFree = both(u > lower, u < upper);
            u = smaller(larger(u, lower), upper);
            impulse = (u - v0) / divisor;
            // Stops are as soft as what holds.
            const F leak = p.old * pass.soft.impulseScale, soft = (impulse - p.old) * pass.soft.massScale - leak;
            impulse = isFree ? impulse : p.old + soft;
        }
        impulse = movable ? impulse : F{};
        push(r, impulse - p.old);
        p.old = impulse;
        if (pass.told != nullptr) tell(r, pushed, high, movable ? growth / divisor : F{}, v0 + w * impulse);
    }

    void tell(int r, F pushed, F high, F slope, F after) const {
        const Row& p = row[r];
        const F told[] = {p.axis.x,       p.axis.y, p.axis.turnA, p.axis.turnB, p.second.x, p.second.y, p.second.turnA,
                          p.second.turnB, pushed,   high,         slope,        after,      p.old};
        for (int i = 0; i < N::told; ++i) storeLanes(pass.told + (r * N::told + i) * batchLanes, told[i]);
    }

    bool isHeld(int r) const { return r < shape.rows && shape.holds[r]; }
    F coupling(int r, int s) const {
        if (!isHeld(r) || !isHeld(s)) return F{};
        if (r == s) return inverseMass(r);
        return link[0].inverseMass(row[r].axis, row[s].axis);
    }
    static F inverse(F pivot, F whole) {
        const auto some = pivot > 1e-7f * whole;
        return some ? 1.0f / (some ? pivot : of(1)) : F{};
    }

    /// The rows that hold, by an L D L^T decomposition. Where gaps close at the most allowed speed, the impulses must
    /// not leak: else a load opens them for ever.
    void hold() {
        F wanted[3] = {}, squares{}, rate{}, massScale = of(1), leak{};
        if (pass.correct) {
            forRows([&](int r) { squares += isHeld(r) ? row[r].coordinate * row[r].coordinate : F{}; });
            rate = smaller(of(pass.soft.biasRate), pass.fastest / larger(squareRoot<W>(squares), of(1e-9f)));
            massScale = of(pass.soft.massScale);
            leak = rate < of(pass.soft.biasRate) ? F{} : of(pass.soft.impulseScale);
        }
        forRows([&](int r) {
            if (isHeld(r)) wanted[r] = speed(r);
            if (isHeld(r) && pass.correct) wanted[r] += row[r].coordinate * rate - bendOf(r);
        });
        const F k00 = coupling(0, 0), i0 = inverse(k00, k00), l10 = coupling(1, 0) * i0;
        const F k11 = coupling(1, 1), d1 = k11 - l10 * l10 * k00, i1 = inverse(d1, k11);
        F x[3] = {wanted[0] * i0, (wanted[1] - l10 * wanted[0]) * i1, F{}};
        if (isHeld(2)) {
            const F l20 = coupling(2, 0) * i0, l21 = (coupling(2, 1) - l10 * coupling(2, 0)) * i1, k22 = coupling(2, 2);
            const F i2 = inverse(k22 - l20 * l20 * k00 - l21 * l21 * d1, k22);
            x[2] = (wanted[2] - l20 * wanted[0] - l21 * (wanted[1] - l10 * wanted[0])) * i2;
            x[1] -= l21 * x[2];
            x[0] -= l20 * x[2];
        }
        x[0] -= l10 * x[1];
        forRows([&](int r) {
            if (!isHeld(r)) return;
            const F change = -x[r] * massScale - row[r].old * leak;
            push(r, change);
            row[r].old += change;
            if (!AllHinges && pass.told != nullptr) tell(r, F{}, F{}, F{}, F{});
        });
    }

    void keep(int r) const {
        const Row& p = row[r];
        const Axis& u = isTwofold() ? p.second : p.axis;
        if (!AllHinges || !shape.alongY[r]) set(N::LoadX, at(N::LoadX) + (AllHinges ? p.old : p.old * u.x));
        if (!AllHinges || shape.alongY[r]) set(N::LoadY, at(N::LoadY) + (AllHinges ? p.old : p.old * u.y));
        if (!AllHinges && (shape.turnsOnly || shape.axis[r] == RowAxis::Turning))
            set(N::LoadTurn, at(N::LoadTurn) + p.old * u.turnB);
        F kept = p.old;
        if (isMissing(r)) kept = row[0].old * u.x - row[1].old * u.y;
        if (!AllHinges && shape.axis[r] == RowAxis::Beside) kept = row[1].old * u.y - row[0].old * u.x;
        set(N::Impulse + r, kept);
    }

    void solve() {
        start();
        if (isMissing(0)) turnToMissing();
        forRows([&](int r) {
            if (!shape.holds[r]) drive(r);
        });
        hold();
        forRows([&](int r) { keep(r); });
        store(isTwofold() ? 1 : 0);
    }

    void prepare(const BodyPlace* places) const {
        for (int k = 0; k < shape.links; ++k) {
            const RelativeLanes<W> r = relativeLanes<W>(slots(k, false), slots(k, true), places);
            const Rows<W> a = loadRows<W, 16>(&places->highX + 4, slots(k, false));
            const Rows<W> b = loadRows<W, 16>(&places->highX + 4, slots(k, true));
            const int first = N::joint + k * N::link;
            const auto turn = [&](const Rows<W>& by, int from, int to) {
                const F x = at(from), y = at(from + 1);
                set(to, by.x * x - by.y * y);
                set(to + 1, by.y * x + by.x * y);
            };
            turn(a, first + N::LocalAx, first + N::ArmAx);
            turn(b, first + N::LocalBx, first + N::ArmBx);
            set(first + N::ApartX, r.apartX + at(first + N::ShiftX) + (at(first + N::ArmBx) - at(first + N::ArmAx)));
            set(first + N::ApartY, r.apartY + at(first + N::ShiftY) + (at(first + N::ArmBy) - at(first + N::ArmAy)));
            set(first + N::InverseGyrationA, a.z);
            set(first + N::InverseGyrationB, b.z);
            for (int i = 0; i < shape.rows; ++i) {
                const int own = shape.first[i], local = k == 0 ? int{N::LocalX} : int{N::SecondLocalX};
                if (own > 0 && (k > 0 || !shape.holds[i] || shape.axis[i] == RowAxis::OnA))
                    turn(a, own + local, own + local + 2);
            }
        }
        for (int load = N::LoadX; load <= N::LoadTurn; ++load) set(load, F{});
    }
};

template <int W>
struct WideSweptJoints {
    template <bool AllHinges>
    static void sweepAs(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const SolverBodies& all,
                        const SweptPass& each) {
        SweptPass pass = each;
        const SweptForm& shape = AllHinges ? plainHinge : batch.shape;
        for (int lane = 0; lane < batchLanes; lane += W) {
            SweptLanes<W, AllHinges> lanes{shape, fields + lane, bodies + lane, all, pass};
            pass.isFirstGuess ? lanes.warm() : lanes.solve();
            if (pass.told != nullptr) pass.told += W;
        }
    }
    [[gnu::flatten]] static void sweepPlain(const SweptBatch& batch, float* fields, const std::uint32_t* bodies,
                                            const SolverBodies& all, const SweptPass& pass) {
        sweepAs<true>(batch, fields, bodies, all, pass);
    }
    static void solve(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const SolverBodies& all,
                      const SweptPass& pass) {
        (batch.isPlain ? sweepPlain : sweepAs<false>)(batch, fields, bodies, all, pass);
    }
    static void prepare(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const BodyPlace* places) {
        const SolverBodies none;
        const SweptPass pass;
        for (int lane = 0; lane < batchLanes; lane += W)
            SweptLanes<W, false>{batch.shape, fields + lane, bodies + lane, none, pass}.prepare(places);
    }
};

template <int W>
const SweptKernel WideSweptKernel<W>::code{WideSweptJoints<W>::prepare, WideSweptJoints<W>::solve};

}  // namespace plumb
