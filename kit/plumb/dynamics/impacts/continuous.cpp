// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/continuous.h>

#include <algorithm>
#include <span>
#include <vector>

namespace plumb {

namespace {

/// Where a body stays that meets a wall on its sweep: at the meeting place, and if the wall moves on, at the same place
/// in the wall's frame.
Sweep stayAt(const BodyStore& bodies, const Sweep& way, const WallHit& hit) {
    Sweep stay = way;
    stay.start = way.start + way.shift * hit.time;
    stay.angle = way.angle + way.turn * hit.time;
    const BodyMotion& wall = bodies.motion[hit.wall];
    const Vec2 wallThen = hit.wallSweep.start + hit.wallSweep.shift * hit.time;
    stay.turn = wall.angle - (hit.wallSweep.angle + hit.wallSweep.turn * hit.time);
    stay.shift = (wall.center + hit.shift - stay.start) + Rot::fromAngle(stay.turn) * Vec2(stay.start - wallThen);
    return stay;
}

/// Is it an awake dynamic body that was not moved by impacts and is not in quarantine?
bool isMoved(const BodyStore& bodies, BodyIndex body) {
    const BodyRecord& record = bodies.record[body];
    return record.type == BodyType::Dynamic && record.awake && !bodies.isMovedBy(body, MovedBy::Impacts) &&
           !record.quarantined;
}

/// A body that may have gone through a wall: through the other body of this contact, or, if there is none, through any
/// static body.
struct Suspect {
    BodyIndex body = noBody;
    ContactIndex contact = none;
};

/// Stops bodies at walls, one after the other.
class WallStop {
public:
    WallStop(BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt)
        : bodies_(bodies), contacts_(contacts), view_{bodies, contacts, space}, dt_(dt) {}

    /// Bodies that have moved far for their size, or past which a wall has moved, in the order of their slots.
    std::vector<Suspect> findSuspects() const {
        std::vector<Suspect> suspects;
        for (const BodyIndex body : bodies_.awake)
            if (isMoved(bodies_, body) && hasMovedFar(bodies_, body, dt_)) suspects.push_back({body, none});
        for (const BodyIndex wall : bodies_.kinematic) addSwept(wall, suspects);
        std::sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) {
            return a.body != b.body ? a.body < b.body : a.contact < b.contact;
        });
        return suspects;
    }

    /// Checks one body; suspects: all entries of this body.
    void stop(std::span<const Suspect> suspects) {
        const BodyIndex body = suspects.front().body;
        const Sweep way = sweepOf(bodies_, body, dt_);
        WallSearch search(view_, body, way, {dt_, 0});
        for (const Suspect& suspect : suspects) {
            if (suspect.contact != none) {
                search.searchContact(suspect.contact);
                continue;
            }
            search.searchStatic();
            // Within these bounds, each kinematic body near it has a contact with it, and addSwept has checked that.
            if (!search.isWithinBounds()) search.searchKinematic();
        }
        if (search.first()) stopAt(body, way, {dt_, 0}, *search.first());
    }

    /// Checks the segments one after the other; once a body is stopped, its later segments are skipped.
    void stop(const Trajectories& trajectories) {
        std::vector<BodyIndex> stopped;
        for (const TrajectorySegment& segment : trajectories) {
            const BodyRecord& record = bodies_.record[segment.body];
            const Sweep way = sweepBetween(segment.from, segment.to, record);
            if (!isFar(record, travelOf(way.shift, way.turn, record))) continue;
            if (std::find(stopped.begin(), stopped.end(), segment.body) != stopped.end()) continue;
            const Past past{dt_ - segment.start, dt_ - segment.end};
            WallSearch search(view_, segment.body, way, past);
            search.searchStatic();
            search.searchKinematic();
            if (!search.first()) continue;
            stopAt(segment.body, way, past, *search.first());
            stopped.push_back(segment.body);
        }
    }

private:
    /// Adds bodies near a kinematic body that have moved far relative to it.
    void addSwept(BodyIndex wall, std::vector<Suspect>& suspects) const {
        const WallSweep wallSweep(freeSweep(bodies_, wall, {dt_, 0}));
        forEachContact(bodies_, contacts_, wall, [&](ContactIndex index) {
            const ContactRecord& contact = contacts_[index];
            const bool isA = contact.bodyA == wall;
            const BodyIndex body = isA ? contact.bodyB : contact.bodyA;
            if (!isMoved(bodies_, body)) return;
            const Shape& face = view_.space[isA ? contact.proxyA : contact.proxyB].def.shape;
            Sweep own = sweepOf(bodies_, body, dt_);
            own.start += isA ? contact.shift : Vec2(-contact.shift);
            if (mayCross(wallSweep, own, face, bodies_.record[body])) suspects.push_back({body, index});
        });
    }

    /// Moves the body to where it met the wall. A kinematic wall carries it along, perhaps into a static one, which is
    /// checked, too.
    void stopAt(BodyIndex body, const Sweep& way, const Past& past, const WallHit& hit) {
        Sweep stopped = stayAt(bodies_, way, hit);
        if (bodies_.record[hit.wall].type == BodyType::Kinematic) {
            const Sweep carried = stopped;
            WallSearch search(view_, body, carried, past);
            search.searchStatic();
            if (search.first()) stopped = stayAt(bodies_, carried, *search.first());
        }
        BodyMotion motion = bodies_.motion[body];
        motion.center = stopped.start + stopped.shift;
        motion.angle = stopped.angle + stopped.turn;
        motion.rotation = Rot::fromAngle(motion.angle);
        moveTo(bodies_, body, motion);
    }

    BodyStore& bodies_;
    const ContactStore& contacts_;
    WallView view_;
    double dt_;
};

}  // namespace

void stopAtWalls(BodyStore& bodies, const ContactStore& contacts, const Space& space, const Trajectories& trajectories,
                 double dt) {
    WallStop walls(bodies, contacts, space, dt);
    const std::vector<Suspect> suspects = walls.findSuspects();
    for (auto first = suspects.begin(); first != suspects.end();) {
        const auto last = std::find_if(first, suspects.end(), [&](const Suspect& s) { return s.body != first->body; });
        walls.stop(std::span(first, last));
        first = last;
    }
    walls.stop(trajectories);
}

}  // namespace plumb
