// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/wall_stops.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/solver/body_solver.h>

namespace plumb {

namespace {

/// Most impacts of a body, or of bodies that joints connect, in a sub-step. After that they stay where they are until
/// the sub-step ends.
constexpr int mostImpacts = 8;

/// Joints may give a machine this share of its energy more when it has hit a wall [-].
constexpr double mostGiven = 1.1;

Vec2 shiftOf(const SolverVelocity& v, double time) {
    return Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) * time;
}

double turnOf(const BodyStore& bodies, BodyIndex body, const SolverVelocity& v, double time) {
    return static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration) * time;
}

}  // namespace

/// A body of a group at the place of its hit.
class WallStops::Pushed : public PushedBody {
public:
    Pushed(WallStops& stops, const Group& group, const Hit& hit)
        : stops_(stops), group_(group), body_(hit.body), place_(hit.place) {}
    BodyMotion motion() const override {
        BodyMotion motion = place_;
        const SolverVelocity& v = stops_.bodies_.velocity[body_];
        motion.velocity = shiftOf(v, 1);
        motion.angularVelocity = turnOf(stops_.bodies_, body_, v, 1);
        return motion;
    }
    Vec3 answerTo(const Vec3& impulse) override {
        if (group_.island == nullptr) return velocityChangeBy(stops_.bodies_, body_, impulse);
        const WallStopStores& stores = stops_.stores_;
        return stores.jointPhases->answer(stores.joints, *group_.island, body_, impulse, stops_.h_);
    }
    void push(const Vec3& impulse) override {
        const WallStopStores& stores = stops_.stores_;
        if (group_.island != nullptr)
            return stores.jointPhases->push(stores.joints, *group_.island, body_, impulse, stops_.h_);
        Vec3 velocity = velocityOf(stops_.bodies_, body_);
        plumb::add(velocity, velocityChangeBy(stops_.bodies_, body_, impulse));
        setVelocity(stops_.bodies_, body_, velocity);
    }

private:
    WallStops& stops_;
    const Group& group_;
    BodyIndex body_;
    BodyMotion place_;
};

WallStops::WallStops(const WallStopStores& stores, double h)
    : stores_(stores), bodies_(stores.bodies), view_{stores.bodies, stores.contacts, stores.space}, h_(h) {
    findBeside();
}

void WallStops::findBeside() {
    for (const BodyIndex wall : bodies_.kinematic) {
        forEachContact(bodies_, stores_.contacts, wall, [&](ContactIndex index) {
            const BodyIndex body = otherOf(stores_.contacts[index], wall);
            if (bodies_.isDynamic(body)) beside_.push_back(body);
        });
    }
    std::sort(beside_.begin(), beside_.end());
    beside_.erase(std::unique(beside_.begin(), beside_.end()), beside_.end());
}

bool WallStops::hasMovedFar(BodyIndex body) const {
    const BodyRecord& record = bodies_.record[body];
    const SolverVelocity& v = bodies_.velocity[body];
    return travelOf(shiftOf(v, 1), turnOf(bodies_, body, v, 1), record) * bodies_.lastStep > farShare * record.inradius;
}

/// The same relative to the kinematic bodies that it touches.
bool WallStops::hasMovedFarBeside(BodyIndex body) const {
    const BodyRecord& record = bodies_.record[body];
    const SolverVelocity& v = bodies_.velocity[body];
    bool far = false;
    forEachContact(bodies_, stores_.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = stores_.contacts[index];
        const BodyIndex wall = otherOf(contact, body);
        if (far || bodies_.record[wall].type != BodyType::Kinematic) return;
        const Vec2 image = contact.bodyA == wall ? Vec2(-contact.shift) : contact.shift;
        const BodyMotion there = shifted(bodies_.motion[wall], image);
        const Vec2 relative = shiftOf(v, 1) - velocityAt(there, bodies_.motion[body].center);
        const double turn = turnOf(bodies_, body, v, 1) - there.angularVelocity;
        far = travelOf(relative, turn, record) * bodies_.lastStep > farShare * record.inradius;
    });
    return far;
}

/// The place from which a slow body has moved; of a fast one, rounding would change it.
WallStops::Mover WallStops::moverOf(BodyIndex body) const {
    const SolverDisplacement& d = bodies_.displacement[body];
    const SolverVelocity& v = bodies_.velocity[body];
    const BodyMotion& start = bodies_.motion[body];
    const Vec2 moved = Vec2(static_cast<double>(d.x), static_cast<double>(d.y)) - shiftOf(v, h_);
    return {body, start.center + moved,
            start.angle + static_cast<double>(bodies_.turn[body].angle) - turnOf(bodies_, body, v, h_)};
}

JointIsland* WallStops::islandOf(BodyIndex body) {
    if (stores_.jointPhases == nullptr) return nullptr;
    std::vector<JointIsland>& islands = stores_.joints.islands.islands;
    if (islandOf_.empty()) {
        islandOf_.assign(bodies_.record.size(), none);
        for (std::uint32_t i = 0; i < islands.size(); ++i)
            for (const BodyIndex member : islands[i].bodies) islandOf_[member] = i;
    }
    const std::uint32_t island = islandOf_[body];
    return island != none && islands[island].direct ? &islands[island] : nullptr;
}

/// A body alone is stopped at once; of others, the island is added, or the exact place to an island that is there
/// already.
void WallStops::add(const Mover& mover) {
    if (isAdded_.empty()) isAdded_.assign(bodies_.record.size(), 0);
    if (bodies_.isMovedBy(mover.body, MovedBy::Impacts) || bodies_.record[mover.body].quarantined) return;
    JointIsland* island = islandOf(mover.body);
    if (island == nullptr) {
        if (isAdded_[mover.body] == 0) added_.push_back(mover.body);
        isAdded_[mover.body] = 1;
        alone_.movers.assign(1, mover);
        return stop(alone_);
    }
    if (isAdded_[mover.body] == 0) {
        Group& group = groups_.emplace_back();
        group.island = island;
        for (const BodyIndex member : island->bodies) {
            group.movers.push_back(moverOf(member));
            added_.push_back(member);
            isAdded_[member] = 1;
        }
    }
    for (Group& group : groups_)
        if (group.island == island)
            for (Mover& each : group.movers)
                if (each.body == mover.body) each = mover;
}

void WallStops::afterMove(std::span<const FastBody> fast, double start) {
    start_ = start;
    for (const FastBody& f : fast) {
        if (!hasMovedFar(f.body)) continue;
        const BodyMotion& from = bodies_.motion[f.body];
        const Vec2 moved(static_cast<double>(f.x), static_cast<double>(f.y));
        add({f.body, from.center + moved, from.angle + static_cast<double>(f.angle)});
    }
    for (const BodyIndex body : beside_)
        if (bodies_.isConstrained(body) && (isAdded_.empty() || isAdded_[body] == 0) && hasMovedFarBeside(body))
            add(moverOf(body));
    for (Group& group : groups_) stopIsland(group);
    for (const BodyIndex body : added_) isAdded_[body] = 0;
    added_.clear();
    groups_.clear();
}

/// A body alone moves on from each impact.
void WallStops::stop(Group& group) {
    Mover& mover = group.movers.front();
    Hit hit;
    for (int impacts = 0; firstHit(group, hit.time, hit); ++impacts) {
        mover.center = hit.place.center;
        mover.angle = hit.place.angle;
        if (impacts == mostImpacts || hit.at.manifold.count == 0) return moveOn(mover, 0);
        solve(group, hit, 0);
        moveOn(mover, (1 - hit.time) * h_);
    }
}

/// Joints hold only along the straight way of a whole sub-step, so there is no place between its ends to go on from.
/// The bodies start again, with impulses by which the one that hit a wall comes just to the wall.
void WallStops::stopIsland(Group& group) {
    Hit hit;
    const auto moveAll = [&](double time) {
        for (const Mover& mover : group.movers) moveOn(mover, time);
    };
    for (int impacts = 0; firstHit(group, 0, hit); ++impacts) {
        moveAll(0);
        if (impacts == mostImpacts || hit.at.manifold.count == 0) return;
        solve(group, hit, hit.time);
        moveAll(h_);
    }
}

bool WallStops::firstHit(const Group& group, double done, Hit& first) const {
    first.body = noBody;
    for (const Mover& mover : group.movers) search(mover, done, first);
    return first.body != noBody;
}

void WallStops::search(const Mover& mover, double done, Hit& first) const {
    const BodyIndex body = mover.body;
    if (!bodies_.isDynamic(body)) return;
    const BodyRecord& record = bodies_.record[body];
    const SolverVelocity& v = bodies_.velocity[body];
    const double left = (1 - done) * h_, far = farShare * record.inradius / bodies_.subSteps;
    const Sweep way{mover.center, shiftOf(v, left), mover.angle, turnOf(bodies_, body, v, left), record.localCenter};
    WallSearch search(view_, body, way, {start_ + done * h_, start_ + h_}, far);
    const bool within = isWithinBounds(body);
    if (travelOf(way.shift, way.turn, record) > far && !(within && isFarFromWalls(body))) search.searchStatic();
    if (!within)
        search.searchKinematic();
    else if (isBeside(body))
        search.searchTouching();
    if (!search.first()) return;
    const double time = done + (1 - done) * search.first()->time;
    if (first.body != noBody && time >= first.time) return;
    first = {body, time, left, motionAt(way, search.first()->time, left), *search.first()};
}

/// Is no static shape within the body's bounds? It is found out once a step, because most fast bodies are in the open.
bool WallStops::isFarFromWalls(BodyIndex body) const {
    if (bodies_.wrap.any()) return false;
    if (nearWalls_.empty()) nearWalls_.assign(bodies_.record.size(), NearWalls::Unknown);
    NearWalls& near = nearWalls_[body];
    if (near == NearWalls::Unknown) {
        near = NearWalls::None;
        const Vec2 start = bodies_.motion[body].center, end = start + predictedShift(bodies_, body);
        const double reach = bodies_.record[body].boundingRadius + static_cast<double>(contactMargin);
        const Aabb box = inflate({start.cwiseMin(end), start.cwiseMax(end)}, reach);
        stores_.space.queryFixed(box, [&near](ProxyId, const Vec2&) { near = NearWalls::Some; });
    }
    return near == NearWalls::None;
}

bool WallStops::isBeside(BodyIndex body) const {
    return std::binary_search(beside_.begin(), beside_.end(), body);
}

/// Is the body still within the bounds for which its contacts were made? It may not be, if it was pushed or deflected.
bool WallStops::isWithinBounds(BodyIndex body) const {
    const SolverDisplacement& d = bodies_.displacement[body];
    const double turned = std::fabs(static_cast<double>(bodies_.turn[body].angle)) * bodies_.record[body].turningRadius;
    const Vec2 moved(static_cast<double>(d.x), static_cast<double>(d.y));
    return excessOfPrediction(bodies_, body, moved, turned) < 0.5 * static_cast<double>(contactMargin);
}

void WallStops::solve(Group& group, const Hit& hit, double kept) {
    std::vector<SolverVelocity> before;
    for (const Mover& mover : group.movers) before.push_back(bodies_.velocity[mover.body]);
    Pushed pushed(*this, group, hit);
    const WallImpact impact = solveWallImpact(view_, hit.at, hit.left, pushed, kept);
    if (impact.normalImpulse == 0) return;
    impacts_.push_back(impact);
    if (group.island != nullptr) hold(group);
    for (std::size_t m = 0; m < group.movers.size(); ++m) {
        const SolverVelocity& now = bodies_.velocity[group.movers[m].body];
        SolverVelocity& mark = bodies_.before[group.movers[m].body];  // so that no contact takes it for its own impulse
        mark.x += now.x - before[m].x;
        mark.y += now.y - before[m].y;
        mark.w += now.w - before[m].w;
    }
}

/// Removes the errors in the joints that an impact causes. At speeds without measure that may give energy: then it is
/// left.
void WallStops::hold(const Group& group) {
    std::vector<SolverVelocity> before;
    for (const Mover& mover : group.movers) before.push_back(bodies_.velocity[mover.body]);
    const double energy = energyOf(group);
    stores_.jointPhases->holdOne(stores_.joints, *group.island, h_);
    if (energyOf(group) <= mostGiven * energy) return;
    for (std::size_t m = 0; m < group.movers.size(); ++m) bodies_.velocity[group.movers[m].body] = before[m];
}

/// Kinetic energy [J].
double WallStops::energyOf(const Group& group) const {
    double energy = 0;
    for (const Mover& mover : group.movers) {
        const SolverVelocity& v = bodies_.velocity[mover.body];
        const auto x = static_cast<double>(v.x), y = static_cast<double>(v.y), w = static_cast<double>(v.w);
        energy += 0.5 * bodies_.record[mover.body].mass * (x * x + y * y + w * w);
    }
    return energy;
}

/// Moves a body at its velocity from a mover's place, for a time.
void WallStops::moveOn(const Mover& mover, double time) {
    const SolverVelocity& v = bodies_.velocity[mover.body];
    const BodyMotion& start = bodies_.motion[mover.body];
    SolverDisplacement& d = bodies_.displacement[mover.body];
    SolverTurn& turn = bodies_.turn[mover.body];
    const Vec2 moved = mover.center - start.center + shiftOf(v, time);
    d.x = static_cast<float>(moved.x());
    d.y = static_cast<float>(moved.y());
    turn.angle = static_cast<float>(mover.angle - start.angle + turnOf(bodies_, mover.body, v, time));
    const SinCosMinus1 turned = turnedFar(turn.angle);
    d.sin = turned.sin * turn.gyration;
    d.cosMinus1 = turned.cosMinus1 * turn.gyration;
}

}  // namespace plumb
