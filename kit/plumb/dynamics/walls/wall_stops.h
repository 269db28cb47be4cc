// SPDX-License-Identifier: MIT
// What happens to bodies that go through a wall within a sub-step?
//
// Contacts are predicted, and in most cases they stop a body at the wall. This second test is for bodies whose motion
// differs from the prediction because they were deflected, pushed or spun. After each sub-step the paths of fast bodies
// are searched for walls that they have crossed, or have gone so deep into that the way out is on the wrong side. What
// crosses one is moved back to where it met the wall, the impact is solved there, and it moves on for the rest of the
// sub-step. A body that joints connect to others is moved back with all of them, and they all respond to the impulse.
// Where joints open, because links turn far, the bodies move in pieces of the sub-step that are short enough for the
// joints.
// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, ch. 2.
// Tests: "what flies at walls is never left in the air", "joints hold where they fall on corners"
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/jointed/joint_solver.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// The stores that it reads and writes.
struct WallStopStores {
    BodyStore& bodies;
    const ContactStore& contacts;
    const Space& space;
    JointSolver& joints;
};

class WallStops {
public:
    /// h: length of a sub-step [s]
    WallStops(WallStopStores stores, double h);

    /// Call this after the bodies have moved in a sub-step that began at this time since the step's start [s].
    void afterMove(std::span<const FastBody> fast, double start);
    /// The impacts so far, in the order of sub-steps, in each by the numbers of islands: bodies alone come first.
    const StepList<WallImpact>& impacts() const { return impacts_; }

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
        StepList<Mover> movers;
        double energy = 0;  ///< of an island: kinetic, after the sub-step's move [J]
    };
    struct Hit {
        BodyIndex body = noBody;
        double time = 0;   ///< share of the searched part of the step [-]
        BodyMotion place;  ///< of the body, without its velocity
        WallHit at;
    };

    bool isDeep(BodyIndex body) const { return bodies_.turn[body].farSpeedSquared < 0; }  ///< in a wall
    bool hasMovedFar(BodyIndex body) const;
    Mover moverOf(BodyIndex body) const;
    void add(const Mover& mover);
    void travel(Group& group);
    bool isClear(JointIsland& island);
    bool isNearWalls(const JointIsland& island, Aabb& noWalls) const;
    Aabb sweptBoxOf(const JointIsland& island) const;
    bool isFree(const Aabb& box) const;
    double turnOf(const JointIsland& island) const;
    bool opens(const JointIsland& island) const;
    double turnOf(const Group& group, double time) const;
    double pieceOf(const Group& group, double left) const;
    bool firstHit(const Group& group, const StepPart& part, Hit& first) const;
    void search(const Mover& mover, const StepPart& part, Hit& first) const;
    void solve(Group& group, const Hit& hit, double duration);
    void hold(const Group& group, double time);
    double energyOf(const Group& group) const;
    void moveAll(const Group& group, double time);
    void moveOn(const Mover& mover, double time);
    void goOn(Mover& mover, double time) const;

    WallStopStores stores_;
    BodyStore& bodies_;
    WallView view_;
    double h_, start_ = 0;
    enum class Check : std::uint8_t { Unknown, Clear, Needed };
    StepList<Check> checks_;           ///< of each island, in this sub-step
    StepList<Aabb> noWalls_;           ///< of each island, in this step: a box that no wall reaches into
    StepList<std::uint32_t> groupOf_;  ///< of each body, in this sub-step; none if it is not added
    StepList<BodyIndex> added_;        ///< those, in the order in which they were added
    StepList<Group> groups_;           ///< islands, in this sub-step
    Group alone_;                      ///< its one body changes from call to call
    StepList<WallImpact> impacts_;
    StepList<std::pair<double, std::uint32_t>> places_;  ///< of each impact: its sub-step's start [s], and its island
    StepList<Vec3> before_;                              ///< velocities of a group
};

}  // namespace plumb
