// SPDX-License-Identifier: MIT
// How does a set of bodies move on from one tick to the next?
#pragma once
#include <memory>
#include <span>
#include <vector>

#include <plumb/dynamics/body.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/events.h>
#include <plumb/dynamics/id.h>
#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/solver_settings.h>
#include <plumb/dynamics/step_profile.h>

namespace plumb {

struct WorldDef {
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    bool sleeping = true;    ///< may what rests be left out of the step?
    SolverSettings solver = {};
};

/// What a joint does to hold its bodies, as means over the last step.
struct JointReaction {
    Vec2 force{0, 0};   ///< on bodyB, at its anchor [N]
    double torque = 0;  ///< on bodyB [N m]
};

/// Bodies, their contacts and joints. Can be moved, not copied; what was moved from can only be assigned to or
/// destroyed. Every call that takes a def or an id throws std::invalid_argument when it is not one the world can take,
/// and then changes nothing.
class World {
public:
    explicit World(const WorldDef& def = {});
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    BodyId add(const BodyDef& def);
    JointId join(const JointDef& def);
    void remove(BodyId body);  ///< with its joints
    void remove(JointId joint);

    /// Moves the world on by dt [s], finite and not negative. Never throws for another reason.
    void step(double dt);

    bool contains(BodyId body) const;
    bool contains(JointId joint) const;
    Body body(BodyId body);
    const Body body(BodyId body) const;
    JointReaction reaction(JointId joint) const;

    std::vector<BodyId> bodies() const;  ///< in the order of their slots
    Vec2 gravity() const;
    void setGravity(const Vec2& gravity);  ///< wakes every body [m/s^2]

    // What happened in the last step; valid until the next call that changes the world.
    std::span<const ContactBegin> contactBegins() const;
    std::span<const ContactEnd> contactEnds() const;
    std::span<const Quarantined> quarantines() const;
    StepProfile profile() const;

private:
    std::unique_ptr<WorldState> state_;
};

}  // namespace plumb
