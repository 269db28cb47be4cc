// SPDX-License-Identifier: MIT
#include <plumb/dynamics/walls/wall_stops.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/bodies/solver_velocity.h>

namespace plumb {

namespace {

/// Most impacts of a body, or of bodies that joints connect, in a sub-step [-]; each costs a search of the space. After
/// that they stay where they are until the sub-step ends, and keep their speed. Test: "a disc on a slide meets walls 23
/// times in a sub-step, and waits at one after the 24th"
constexpr int mostImpacts = 24;

/// If joints have opened by more than opensFar [m], their bodies move in pieces in which none turns by more than
/// pieceTurn [rad]: the joints hold at the end of each piece. A sub-step has at most mostPieces equal pieces, each with
/// a search of all its bodies. When machines went back to the start of the sub-step instead, 52 of 500 opened by over
/// 10 cm at walls; in pieces, none by over 3 mm. Test: "a bar whirled at a wall opens its hinge by less than 1 mm at
/// 0.5 rad in a sub-step, and more at 0.7"
constexpr double opensFar = 2e-4, pieceTurn = 0.025, mostPieces = 32;
/// What turns by more than this in a sub-step stays where it met a wall, because its joints cannot be followed [rad].
constexpr double farthestFollowed = 8;

/// Moves in floats are exact to this share of themselves [-].
constexpr double floatError = 1e-6;

/// If less than this share of a sub-step is left, it is over [-].
constexpr double roundOff = 1e-9;

/// Corrections of joints may raise the energy of a machine to at most this share of that before, in a sub-step in which
/// it moves in pieces [-].
constexpr double mostGained = 1.01;

Aabb emptyBox() {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {Vec2(infinite, infinite), Vec2(-infinite, -infinite)};
}

Vec2 shiftOf(const SolverVelocity& v, double time) {
    return Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) * time;
}

double turnBy(const BodyStore& bodies, BodyIndex body, const SolverVelocity& v, double time) {
    return static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration) * time;
}

}  // namespace

WallStops::WallStops(WallStopStores stores, double h)
    : stores_(stores), bodies_(stores.bodies), view_{stores.bodies, stores.contacts, stores.space}, h_(h) {}

/// Would it move by more than farShare of its inradius in a whole step? The limits of SolverTurn are bounds; this is
/// the exact question, and leaves few bodies.
bool WallStops::hasMovedFar(BodyIndex body) const {
    const BodyRecord& record = bodies_.record[body];
    const SolverVelocity& v = bodies_.velocity[body];
    return isDeep(body) ||
           travelOf(shiftOf(v, 1), turnBy(bodies_, body, v, 1), record) * bodies_.lastStep > farShare * record.inradius;
}

/// The place from which a slow body has moved, computed back from where it is now. Of a fast one, rounding would change
/// it: it has its place before the move in FastBody.
WallStops::Mover WallStops::moverOf(BodyIndex body) const {
    const SolverDisplacement& d = bodies_.displacement[body];
    const SolverVelocity& v = bodies_.velocity[body];
    const BodyMotion& start = bodies_.motion[body];
    const Vec2 moved = Vec2(static_cast<double>(d.x), static_cast<double>(d.y)) - shiftOf(v, h_);
    return {body, start.center + moved,
            start.angle + static_cast<double>(bodies_.turn[body].angle) - turnBy(bodies_, body, v, h_)};
}

/// A body alone is stopped at once. Of others, the island is added with all its bodies, whose places are computed back
/// from where they are now; fast ones bring their exact places, which replace these. A body is added once in a
/// sub-step, and groupOf_ is cleared by the list of those added, not whole.
void WallStops::add(const Mover& mover) {
    if (groupOf_.empty()) groupOf_.assign(bodies_.record.size(), none);
    if (!bodies_.isMovedBy(mover.body, MovedBy::ClosedForm) || bodies_.record[mover.body].quarantined) return;
    JointIsland* island = stores_.joints.islandOf(mover.body);
    if (island == nullptr) {
        if (groupOf_[mover.body] == none) added_.push_back(mover.body);
        groupOf_[mover.body] = 0;
        alone_.movers.assign(1, mover);
        return travel(alone_);
    }
    std::uint32_t& number = groupOf_[mover.body];
    if (number == none) {
        const auto added = static_cast<std::uint32_t>(groups_.size());
        Group& group = groups_.emplace_back();
        group.island = island;
        for (const BodyIndex member : island->bodies) {
            group.movers.push_back(moverOf(member));
            added_.push_back(member);
            groupOf_[member] = added;
        }
    }
    for (Mover& each : groups_[number].movers)
        if (each.body == mover.body) each = mover;
}

void WallStops::afterMove(std::span<const FastBody> fast, double start) {
    start_ = start;
    for (const FastBody& f : fast) {
        JointIsland* island = stores_.joints.islandOf(f.body);
        if (island != nullptr && isClear(*island)) continue;
        if (bodies_.kinematic.empty() && !hasMovedFar(f.body)) continue;
        const BodyMotion& from = bodies_.motion[f.body];
        const Vec2 moved(static_cast<double>(f.x), static_cast<double>(f.y));
        add({f.body, from.center + moved, from.angle + static_cast<double>(f.angle)});
    }
    for (Group& group : groups_) travel(group);
    for (const BodyIndex body : added_) groupOf_[body] = none;
    added_.clear();
    checks_.clear();
    groups_.clear();
}

/// Moves a group through the sub-step anew, from impact to impact. All its bodies have moved to the sub-step's end
/// already: there they stay if they meet nothing and their joints hold. In each round: where joints opened, correct the
/// velocities for a piece of the rest; find the first hit on the way; move all to it; solve the impact; go on with the
/// new velocities. The places of the movers are doubles: a fast body would lose the exact place of a hit in floats.
void WallStops::travel(Group& group) {
    double time = 0;
    int impacts = 0;
    bool inPieces = group.island != nullptr && turnOf(group, h_) <= farthestFollowed && opens(*group.island);
    if (group.island != nullptr) group.energy = energyOf(group);
    while (time < h_ * (1 - roundOff)) {
        const double left = h_ - time, piece = inPieces ? pieceOf(group, left) : left;
        if (inPieces) {
            moveAll(group, 0);
            hold(group, piece);
        }
        Hit hit;
        const bool hits = firstHit(group, {start_ + time, start_ + time + piece}, hit);
        if (!hits && !inPieces && impacts == 0) return;
        const double done = hits ? hit.time * piece : piece;
        moveAll(group, done);
        for (Mover& mover : group.movers) goOn(mover, done);
        if (hits) {
            if (++impacts > mostImpacts || hit.at.manifold.count == 0) return;
            solve(group, hit, piece);
            inPieces = group.island != nullptr;
            if (inPieces && turnOf(group, h_) > farthestFollowed) return;
        }
        time = piece < left || hits ? time + done : h_;
    }
}

/// Can the island stay where it has moved, because it is far from walls and its joints hold? Asked once for each island
/// in a sub-step, however many of its bodies are fast.
bool WallStops::isClear(JointIsland& island) {
    const std::span<JointIsland> islands = stores_.joints.islands();
    if (checks_.empty()) checks_.assign(islands.size(), Check::Unknown);
    if (noWalls_.empty()) noWalls_.assign(islands.size(), emptyBox());
    const auto number = static_cast<std::size_t>(&island - islands.data());
    Check& check = checks_[number];
    if (check == Check::Unknown) {
        const bool followed = turnOf(island) <= farthestFollowed;
        const bool needed = isNearWalls(island, noWalls_[number]) || (followed && opens(island));
        check = needed ? Check::Needed : Check::Clear;
    }
    return check == Check::Clear;
}

/// Is there anything that one of its bodies could have met? One question for all of them. The box is at first empty.
/// Then walls are looked for within some distance at once, so that the coming sub-steps need not.
bool WallStops::isNearWalls(const JointIsland& island, Aabb& noWalls) const {
    if (!bodies_.kinematic.empty() || bodies_.wrap.any()) return true;
    const Aabb swept = sweptBoxOf(island);
    if (contains(noWalls, swept)) return false;
    double speed = 0;
    for (const BodyIndex body : island.bodies) speed = std::max(speed, shiftOf(bodies_.velocity[body], 1).norm());
    const Aabb wide = inflate(swept, speed * bodies_.lastStep);
    if (isFree(wide)) {
        noWalls = wide;
        return false;
    }
    return !isFree(swept);
}

bool WallStops::isFree(const Aabb& box) const {
    bool free = true;
    view_.space.queryFixed(box, [&free](ProxyId, const Vec2&) { free = false; });
    return free;
}

/// The box around all that its bodies have swept over in the last sub-step.
Aabb WallStops::sweptBoxOf(const JointIsland& island) const {
    Aabb box = emptyBox();
    for (const BodyIndex body : island.bodies) {
        const SolverDisplacement& d = bodies_.displacement[body];
        const Vec2 moved(static_cast<double>(d.x), static_cast<double>(d.y)),
            last = shiftOf(bodies_.velocity[body], h_);
        const Vec2 to = bodies_.motion[body].center + moved, from = to - last;
        const double reach = bodies_.record[body].boundingRadius + floatError * (moved.norm() + last.norm());
        const Aabb swept = inflate({from.cwiseMin(to), from.cwiseMax(to)}, reach);
        box = {box.lower.cwiseMin(swept.lower), box.upper.cwiseMax(swept.upper)};
    }
    return box;
}

/// The largest turn of its bodies in a sub-step [rad].
double WallStops::turnOf(const JointIsland& island) const {
    double turn = 0;
    for (const BodyIndex body : island.bodies)
        turn = std::max(turn, std::fabs(turnBy(bodies_, body, bodies_.velocity[body], h_)));
    return turn;
}

/// Have joints opened since the step began?
bool WallStops::opens(const JointIsland& island) const {
    return stores_.joints.openingOf(island) > opensFar;
}

/// How long a piece of the rest of a sub-step may be [s].
double WallStops::pieceOf(const Group& group, double left) const {
    const double pieces = std::min(std::ceil(turnOf(group, left) / pieceTurn), std::ceil(mostPieces * left / h_));
    return pieces > 1 ? left / pieces : left;
}

/// The largest turn of its bodies in a time [rad].
double WallStops::turnOf(const Group& group, double time) const {
    double turn = 0;
    for (const Mover& mover : group.movers)
        turn = std::max(turn, std::fabs(turnBy(bodies_, mover.body, bodies_.velocity[mover.body], time)));
    return turn;
}

bool WallStops::firstHit(const Group& group, const StepPart& part, Hit& first) const {
    first.body = noBody;
    for (const Mover& mover : group.movers) search(mover, part, first);
    return first.body != noBody;
}

/// What may be crossed unseen is in proportion to the time that is searched, so short pieces do not add up to a
/// passage.
void WallStops::search(const Mover& mover, const StepPart& part, Hit& first) const {
    const BodyIndex body = mover.body;
    if (!bodies_.isDynamic(body)) return;
    const BodyRecord& record = bodies_.record[body];
    const SolverVelocity& v = bodies_.velocity[body];
    const double left = part.to - part.from,
                 far = isDeep(body) ? 0 : farShare * record.inradius * left / bodies_.lastStep;
    const Sweep sweep{mover.center, shiftOf(v, left), mover.angle, turnBy(bodies_, body, v, left), record.localCenter};
    WallSearch search(view_, body, sweep, part, far);
    if (travelOf(sweep.shift, sweep.turn, record) > far) search.searchStatic();
    search.searchKinematic();
    if (!search.first()) return;
    const double time = search.first()->time;
    if (first.body != noBody && time >= first.time) return;
    first = {body, time, motionAt(sweep, time, left), *search.first()};
}

void WallStops::solve(Group& group, const Hit& hit, double duration) {
    SolvedBodies both(bodies_, stores_.joints, view_.space[hit.at.wall].owner, hit.body);
    const WallImpact impact = solveWallImpact(view_, hit.at, wallMotionAt(hit.at, duration), hit.place, both);
    if (impact.normalImpulse == 0) return;
    const JointIsland* first = stores_.joints.islands().data();
    const auto order = group.island == nullptr ? 0 : static_cast<std::uint32_t>(group.island - first + 1);
    // Islands that meet no contact go through the whole step before all others: so impacts are not found in the order
    // of time.
    const std::pair place(start_, order);
    const auto at = std::upper_bound(places_.begin(), places_.end(), place) - places_.begin();
    places_.insert(places_.begin() + at, place);
    impacts_.insert(impacts_.begin() + at, impact);
}

/// Changes the velocities so that the joints hold after a time. At very high speeds that may add energy: then the
/// velocities stay as they are, and the joints open rather than that the machine speeds up.
void WallStops::hold(const Group& group, double time) {
    before_.clear();
    for (const Mover& mover : group.movers) before_.push_back(velocityOf(bodies_, mover.body));
    stores_.joints.closeGaps(*group.island, time);
    if (energyOf(group) > mostGained * group.energy)
        for (std::size_t m = 0; m < group.movers.size(); ++m) setVelocity(bodies_, group.movers[m].body, before_[m]);
}

/// Kinetic energy [J].
double WallStops::energyOf(const Group& group) const {
    double energy = 0;
    for (const Mover& mover : group.movers) {
        const SolverVelocity& v = bodies_.velocity[mover.body];
        const auto x = static_cast<double>(v.x), y = static_cast<double>(v.y), w = turnBy(bodies_, mover.body, v, 1);
        const BodyRecord& record = bodies_.record[mover.body];
        energy += 0.5 * (record.mass * (x * x + y * y) + record.inertia * (w * w));
    }
    return energy;
}

/// Moves the bodies at their velocities from the places of their movers, for a time.
void WallStops::moveAll(const Group& group, double time) {
    for (const Mover& mover : group.movers) moveOn(mover, time);
    if (group.island != nullptr) group.island->batch->noteMoves();
}

void WallStops::moveOn(const Mover& mover, double time) {
    const SolverVelocity& v = bodies_.velocity[mover.body];
    const BodyMotion& start = bodies_.motion[mover.body];
    SolverDisplacement& d = bodies_.displacement[mover.body];
    SolverTurn& turn = bodies_.turn[mover.body];
    const Vec2 moved = mover.center - start.center + shiftOf(v, time);
    d.x = static_cast<float>(moved.x());
    d.y = static_cast<float>(moved.y());
    turn.angle = static_cast<float>(mover.angle - start.angle + turnBy(bodies_, mover.body, v, time));
    const SinCosMinus1 turned = turnedFar(turn.angle);
    d.sin = turned.sin * turn.gyration;
    d.cosMinus1 = turned.cosMinus1 * turn.gyration;
}

void WallStops::goOn(Mover& mover, double time) const {
    const SolverVelocity& v = bodies_.velocity[mover.body];
    mover.center += shiftOf(v, time);
    mover.angle += turnBy(bodies_, mover.body, v, time);
}

}  // namespace plumb
