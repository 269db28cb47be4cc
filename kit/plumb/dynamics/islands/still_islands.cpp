// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/still_islands.h>

#include <algorithm>

#include <plumb/dynamics/contacts/narrow_phase.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/dynamics/islands/neighbours.h>
#include <plumb/dynamics/islands/stillness.h>
#include <plumb/math/vec2.h>

namespace plumb {

namespace {

/// How far a body may come in a step, as the narrow phase sees it [m]. At rest it is g dt^2 / 2, because the prediction
/// contains no contact forces.
float reachOf(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    return Vec2f(place.shiftX, place.shiftY).norm() + place.turn;
}

/// Would one of the two bodies wake the other if that one slept? The same question as that of the narrow phase
/// (NarrowPhase::noteSleepers), so that no island falls asleep to be woken in the next step. Test: "a pit of capsules
/// falls asleep, although some are near without touching"
bool wouldWake(const SleepStores& stores, const ContactRecord& contact) {
    const BodyStore& bodies = stores.bodies;
    if (letsPass(contact.verdict)) return false;
    const float distance = wakeDistance + std::max(reachOf(bodies, contact.bodyA), reachOf(bodies, contact.bodyB));
    const BodyMotion b = shifted(bodies.motion[contact.bodyB], contact.shift);
    const RelativePose pose = relativePose(bodies.motion[contact.bodyA], b);
    return manifold(stores.space[contact.proxyA].convex, stores.space[contact.proxyB].convex, pose, distance).count > 0;
}

/// A search begins at a body that has been still for long enough. It ends at the first that has not, or whose island is
/// known to stay awake: so a heap in which something moves costs a few looks, not a walk through it.
class IslandSearch {
public:
    IslandSearch(SleepStores& stores, double sleepTime)
        : stores_(stores), sleepTime_(sleepTime), marks_(stores.bodies.record.size(), Mark::None) {}

    bool mayBeginAt(BodyIndex body) const { return marks_[body] == Mark::None && isReady(body) && !isBlocked(body); }

    /// The island of a body; empty if it stays awake.
    StepList<BodyIndex> islandOf(BodyIndex seed) {
        island_.clear();
        still_ = true;
        reach(seed);
        // First all that touches or is joined, which is cheap to find; only then what is near.
        for (std::size_t joined = 0, near = 0; still_ && near < island_.size();) {
            if (joined < island_.size())
                anyNeighbour(stores_.bodies, stores_.contacts, stores_.joints, island_[joined++],
                             [this](BodyIndex other) { return !reach(other); });
            else
                reachNear(island_[near++]);
        }
        // All that were found are of the same island: none of them need start a search in this step, nor in the next
        // ones.
        if (!still_) {
            for (const BodyIndex body : island_) block(body);
            island_.clear();
        }
        return island_;
    }

private:
    enum class Mark : std::uint8_t { None, Found, StaysAwake };

    bool isReady(BodyIndex body) const {
        return stores_.bodies.canMove(body) && stores_.bodies.record[body].stillTime >= sleepTime_;
    }

    /// Is a body that kept the island awake not long ago still restless? To find that out again for the whole island in
    /// each step would take long.
    bool isBlocked(BodyIndex body) const {
        const StillWatch& watch = stores_.bodies.watch[body];
        return watch.blocker != noBody && stores_.bodies.record[body].stillTime < watch.blockedUntil &&
               !isReady(watch.blocker);
    }

    void block(BodyIndex body) {
        marks_[body] = Mark::StaysAwake;
        StillWatch& watch = stores_.bodies.watch[body];
        watch.blocker = blocker_;
        watch.blockedUntil = stores_.bodies.record[body].stillTime + blockedFor_;
    }

    /// Returns whether the island may still sleep.
    bool reach(BodyIndex body) {
        if (marks_[body] == Mark::Found) return true;
        const bool ready = isReady(body);
        still_ = ready && marks_[body] == Mark::None && !isBlocked(body);
        if (still_) {
            marks_[body] = Mark::Found;
            island_.push_back(body);
            return true;
        }
        const StillWatch& watch = stores_.bodies.watch[body];
        blocker_ = ready ? watch.blocker : body;
        blockedFor_ = ready ? watch.blockedUntil - stores_.bodies.record[body].stillTime : sleepTime_;
        return false;
    }

    void reachNear(BodyIndex body) {
        anyContact(stores_.bodies, stores_.contacts, body, [&](ContactIndex index) {
            const ContactRecord& contact = stores_.contacts[index];
            const BodyIndex other = otherOf(contact, body);
            // What touches was found before; manifolds are computed only for the rest.
            if (contact.touching || marks_[other] == Mark::Found) return false;
            const bool wakes =
                stores_.bodies.canMove(other) && stores_.bodies.record[other].awake && wouldWake(stores_, contact);
            return wakes && !reach(other);
        });
    }

    SleepStores& stores_;
    double sleepTime_;
    StepList<Mark> marks_;
    StepList<BodyIndex> island_;
    BodyIndex blocker_ = noBody;  ///< the body that keeps the island awake
    double blockedFor_ = 0;       ///< for how long its bodies are not searched from [s]
    bool still_ = true;
};

/// Begins to watch the driven bodies of an island again. Returns whether there are any.
bool watchDriven(SleepStores& stores, const SolverSettings& settings, const StepList<BodyIndex>& island) {
    bool driven = false;
    for (const BodyIndex body : island) {
        if (!isCarried(stores.bodies, stores.contacts, stores.joints, body) &&
            !isDriven(stores.bodies, stores.contacts, stores.joints, settings, body))
            continue;
        // Its watch begins anew: an island with a running drive is searched again after sleepTime, not in each step.
        stores.bodies.record[body].stillTime = 0;
        driven = true;
    }
    return driven;
}

}  // namespace

StepList<StepList<BodyIndex>> findStillIslands(SleepStores& stores, const SolverSettings& settings) {
    StepList<StepList<BodyIndex>> islands;
    IslandSearch search(stores, settings.sleepTime);
    for (const BodyIndex seed : stores.bodies.awake) {
        if (!search.mayBeginAt(seed)) continue;
        StepList<BodyIndex> island = search.islandOf(seed);
        if (!island.empty() && !watchDriven(stores, settings, island)) islands.push_back(std::move(island));
    }
    return islands;
}

}  // namespace plumb
