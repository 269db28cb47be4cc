// SPDX-License-Identifier: MIT
// What happens to bodies that go through a wall within a sub-step?
//
// Contacts are predicted, and in most cases they stop a body at the wall. This second test is for bodies whose motion
// differs from the prediction because they were deflected, pushed or spun. After each sub-step the paths of fast bodies
// are searched for walls that they have crossed, or have gone so deep into that the way out is on the wrong side. What
// crosses one is moved back to where it met the wall, the impact is solved there, and it moves on for the rest of the
// sub-step. A body that joints connect to others is moved back with all of them, and they all answer to the impulse.
// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, ch. 2.
// Tests: "what flies at walls is never left in the air", "joints hold where they fall on corners"
#pragma once
#include <vector>

#include <plumb/dynamics/impacts/wall_impact.h>
#include <plumb/dynamics/solver/body_solver.h>
#include <plumb/dynamics/solver/joint_phases.h>

namespace plumb {

/// The stores that it reads and writes.
struct WallStopStores {
    BodyStore& bodies;
    const ContactStore& contacts;
    const Space& space;
    const JointPhases* jointPhases = nullptr;  ///< null if the world has no joints
    const JointStores& joints;
};

class WallStops {
public:
    /// h: length of a sub-step [s]
    WallStops(const WallStopStores& stores, double h);

    /// Call this after the bodies have moved in a sub-step that began at this time since the step's start [s].
    void afterMove(std::span<const FastBody> fast, double start);
    /// The impacts so far, in the order in which they were found.
    const std::vector<WallImpact>& impacts() const { return impacts_; }

private:
    /// A body, and its place at the time from which it moves on.
    struct Mover {
        BodyIndex body = noBody;
        Vec2 center{0, 0};  ///< [m]
        double angle = 0;   ///< [rad]
    };
    /// What moves as one: the bodies of a joint island, or a body alone.
    struct Group {
        JointIsland* island = nullptr;
        std::vector<Mover> movers;
    };
    struct Hit {
        BodyIndex body = noBody;
        double time = 0;   ///< share of the sub-step [-]
        double left = 0;   ///< duration of the sweep in which it was found [s]
        BodyMotion place;  ///< of the body, without its velocity
        WallHit at;
    };
    class Pushed;
    /// Are there static shapes within a body's bounds?
    enum class NearWalls : std::uint8_t { Unknown, None, Some };

    void findBeside();
    bool hasMovedFar(BodyIndex body) const;
    bool hasMovedFarBeside(BodyIndex body) const;
    Mover moverOf(BodyIndex body) const;
    void add(const Mover& mover);
    JointIsland* islandOf(BodyIndex body);
    void stop(Group& group);
    void stopIsland(Group& group);
    bool firstHit(const Group& group, double done, Hit& first) const;
    void search(const Mover& mover, double done, Hit& first) const;
    bool isFarFromWalls(BodyIndex body) const;
    bool isBeside(BodyIndex body) const;
    bool isWithinBounds(BodyIndex body) const;
    void solve(Group& group, const Hit& hit, double kept);
    void hold(const Group& group);
    double energyOf(const Group& group) const;
    void moveOn(const Mover& mover, double time);

    WallStopStores stores_;
    BodyStore& bodies_;
    WallView view_;
    double h_, start_ = 0;
    std::vector<BodyIndex> beside_;             ///< bodies that have a contact with a kinematic body, sorted
    std::vector<std::uint32_t> islandOf_;       ///< of each body, none if it is alone; empty until it is needed
    std::vector<std::uint8_t> isAdded_;         ///< of each body, in this sub-step
    std::vector<BodyIndex> added_;              ///< those, in the order in which they were added
    std::vector<Group> groups_;                 ///< islands, in this sub-step
    Group alone_;                               ///< its one body changes from call to call
    mutable std::vector<NearWalls> nearWalls_;  ///< of each body; empty until it is needed
    std::vector<WallImpact> impacts_;
};

}  // namespace plumb
