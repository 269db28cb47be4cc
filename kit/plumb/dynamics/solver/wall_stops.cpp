// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/wall_stops.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/solver/body_solver.h>
#include <plumb/dynamics/solver/solver.h>

namespace plumb {

namespace {

/// Most impacts of a body, or of bodies that joints connect, in a sub-step. After that they stay where they are until
/// the sub-step ends.
constexpr int mostImpacts = 8;

Vec2 shiftOf(const SolverVelocity& v, double time) {
    return Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) * time;
}

double turnOf(const BodyStore& bodies, BodyIndex body, const SolverVelocity& v, double time) {
    return static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration) * time;
}

SolverVelocity difference(const SolverVelocity& a, const SolverVelocity& b) {
    return {a.x - b.x, a.y - b.y, a.w - b.w, 0};
}

SolverVelocity opposite(const SolverVelocity& v) {
    return difference({}, v);
}

/// The sweep of the last part of a sub-step, of this duration [s].
Sweep lastPart(const BodyStore& bodies, BodyIndex body, double duration) {
    const SolverDisplacement& d = bodies.displacement[body];
    const SolverVelocity& v = bodies.velocity[body];
    const BodyMotion& start = bodies.motion[body];
    Sweep way;
    way.localCenter = bodies.record[body].localCenter;
    way.shift = shiftOf(v, duration);
    way.turn = turnOf(bodies, body, v, duration);
    way.start = start.center + Vec2(static_cast<double>(d.x), static_cast<double>(d.y)) - way.shift;
    way.angle = start.angle + static_cast<double>(bodies.turn[body].angle) - way.turn;
    return way;
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
        const SolverStores& stores = stops_.stores_;
        return stores.jointPhases->answer(stores.joints, *group_.island, body_, impulse, stops_.h_);
    }
    void push(const Vec3& impulse) override {
        const SolverStores& stores = stops_.stores_;
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

WallStops::WallStops(const SolverStores& stores, double h)
    : stores_(stores), bodies_(stores.bodies), view_{stores.bodies, stores.contacts, stores.space}, h_(h) {
    findBeside();
}

void WallStops::findBeside() {
    for (const BodyIndex wall : bodies_.kinematic) {
        if (!bodies_.record[wall].awake) continue;
        forEachContact(bodies_, stores_.contacts, wall, [&](ContactIndex index) {
            const BodyIndex body = otherOf(stores_.contacts[index], wall);
            if (bodies_.isConstrained(body)) beside_.push_back(body);
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

void WallStops::add(BodyIndex body) {
    if (isAdded_.empty()) isAdded_.assign(bodies_.record.size(), 0);
    if (isAdded_[body] != 0 || bodies_.isMovedBy(body, MovedBy::Impacts) || bodies_.record[body].quarantined) return;
    if (stores_.jointPhases != nullptr && islandOf_.empty()) {
        islandOf_.assign(bodies_.record.size(), none);
        const std::vector<JointIsland>& islands = stores_.joints.islands.islands;
        for (std::uint32_t i = 0; i < islands.size(); ++i)
            for (const BodyIndex member : islands[i].bodies) islandOf_[member] = i;
    }
    Group& group = groups_.emplace_back();
    const std::uint32_t island = islandOf_.empty() ? none : islandOf_[body];
    if (island != none && stores_.joints.islands.islands[island].direct) {
        group.island = &stores_.joints.islands.islands[island];
        group.bodies = group.island->bodies;
    } else {
        group.bodies.push_back(body);
    }
    for (const BodyIndex member : group.bodies) isAdded_[member] = 1;
}

void WallStops::afterMove(std::span<const BodyIndex> fast, double start) {
    start_ = start;
    for (const BodyIndex body : fast)
        if (hasMovedFar(body)) add(body);
    for (const BodyIndex body : beside_)
        if (hasMovedFarBeside(body)) add(body);
    for (const Group& group : groups_) {
        stop(group);
        for (const BodyIndex body : group.bodies) isAdded_[body] = 0;
    }
    groups_.clear();
}

/// A body alone moves on from each impact.
void WallStops::stop(const Group& group) {
    if (group.island != nullptr) return stopIsland(group);
    const BodyIndex body = group.bodies.front();
    Hit hit;
    for (int impacts = 0; firstHit(group, hit.time, hit); ++impacts) {
        const double left = (1 - hit.time) * h_;
        if (impacts == mostImpacts) return moveOn(body, opposite(bodies_.velocity[body]), left);
        const SolverVelocity before = bodies_.velocity[body];
        solve(group, hit, 0);
        moveOn(body, difference(bodies_.velocity[body], before), left);
    }
}

/// Joints hold only along the straight way of a whole sub-step, so there is no place between its ends to go on from.
/// The bodies start again, with impulses by which the one that hit a wall comes just to the wall.
void WallStops::stopIsland(const Group& group) {
    Hit hit;
    const auto moveAll = [&](double time) {
        for (const BodyIndex body : group.bodies) moveOn(body, bodies_.velocity[body], time);
    };
    for (int impacts = 0; firstHit(group, 0, hit); ++impacts) {
        moveAll(-h_);
        if (impacts == mostImpacts) return;
        solve(group, hit, hit.time);
        moveAll(h_);
    }
}

bool WallStops::firstHit(const Group& group, double done, Hit& first) const {
    first.body = noBody;
    for (const BodyIndex body : group.bodies) search(body, done, first);
    return first.body != noBody;
}

void WallStops::search(BodyIndex body, double done, Hit& first) const {
    const BodyRecord& record = bodies_.record[body];
    if (!bodies_.isDynamic(body)) return;
    const double left = (1 - done) * h_, far = farShare * record.inradius / bodies_.subSteps;
    const Sweep way = lastPart(bodies_, body, left);
    WallSearch search(view_, body, way, {start_ + done * h_, start_ + h_}, far);
    if (travelOf(way.shift, way.turn, record) > far) search.searchStatic();
    if (!bodies_.kinematic.empty()) {
        if (isWithinBounds(body))
            search.searchTouching();
        else
            search.searchKinematic();
    }
    if (!search.first()) return;
    const double time = done + (1 - done) * search.first()->time;
    if (first.body != noBody && time >= first.time) return;
    first = {body, time, left, motionAt(way, search.first()->time, left), *search.first()};
}

/// Is the body still within the bounds for which its contacts were made? It may not be, if it was pushed or deflected.
bool WallStops::isWithinBounds(BodyIndex body) const {
    const SolverDisplacement& d = bodies_.displacement[body];
    const double turned = std::fabs(static_cast<double>(bodies_.turn[body].angle)) * bodies_.record[body].turningRadius;
    const Vec2 moved(static_cast<double>(d.x), static_cast<double>(d.y));
    return excessOfPrediction(bodies_, body, moved, turned) < 0.5 * static_cast<double>(contactMargin);
}

void WallStops::solve(const Group& group, const Hit& hit, double kept) {
    std::vector<SolverVelocity> before;
    for (const BodyIndex body : group.bodies) before.push_back(bodies_.velocity[body]);
    Pushed pushed(*this, group, hit);
    impacts_.push_back(solveWallImpact(view_, hit.at, hit.left, pushed, kept));
    if (group.island != nullptr) stores_.jointPhases->holdOne(stores_.joints, *group.island, h_);
    for (std::size_t b = 0; b < group.bodies.size(); ++b) {
        const SolverVelocity change = difference(bodies_.velocity[group.bodies[b]], before[b]);
        SolverVelocity& mark = bodies_.before[group.bodies[b]];  // so that no contact takes it for its own impulse
        mark.x += change.x;
        mark.y += change.y;
        mark.w += change.w;
    }
}

/// Changes where a body is by a velocity and a time.
void WallStops::moveOn(BodyIndex body, const SolverVelocity& change, double time) {
    SolverDisplacement& d = bodies_.displacement[body];
    SolverTurn& turn = bodies_.turn[body];
    const Vec2 shift = shiftOf(change, time);
    d.x += static_cast<float>(shift.x());
    d.y += static_cast<float>(shift.y());
    turn.angle += static_cast<float>(turnOf(bodies_, body, change, time));
    const SinCosMinus1 turned = turnedFar(turn.angle);
    d.sin = turned.sin * turn.gyration;
    d.cosMinus1 = turned.cosMinus1 * turn.gyration;
}

}  // namespace plumb
