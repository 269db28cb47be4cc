// SPDX-License-Identifier: MIT
// How does each body that takes part in impacts move from one impact to the next?
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/bodies/time_of_impact.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/fields/field_flight.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// The stores that impacts read and write.
struct ImpactStores : MeetingStores {
    FieldStore& fields;
};

/// The number of a body in FlyingBodies.
using FlyingIndex = std::uint32_t;

/// The work that a group of bodies has made in this step.
struct ImpactWork {
    std::size_t pairs = 0;        ///< of its bodies, each counted once
    std::size_t predictions = 0;  ///< of their impacts
};

/// A body since its last impact.
struct FlyingBody {
    BodyIndex body = noBody;
    bool isDynamic = false;
    bool isHit = false;              ///< it had an impact in this step
    bool isStopped = false;          ///< it stays where it is until the step ends, see FlyingBodies::stop
    bool isLeft = false;             ///< only for the first body of a group: it is left to the solver
    ImpactWork work;                 ///< only for the first body of a group: that of the whole group
    FlyingIndex parent = 0;          ///< leads to the first body of its group
    std::uint32_t firstPair = none;  ///< head of the list of its pairs
    std::uint32_t fields = none;     ///< its entry in the list of bodies on which varying fields act
    MovingShape flight;              ///< its shape is set for each contact
};

/// The effect of varying fields on a flying body.
struct FlyingFields {
    FieldFlight flight;    ///< from the last impact on
    FieldAccount account;  ///< before the last impact
};

/// The bodies that take part in the impacts of a step. Bodies that have hit each other form a group. A group is moved
/// through the step here, or all of it is left to the solver.
class FlyingBodies {
public:
    FlyingBodies(ImpactStores& stores, double dt);
    void reserve(std::size_t bodies) { bodies_.reserve(std::min(bodies, numberOf_.size())); }

    /// The number of a body; a body that is new gets one. isObstacle: the solver moves it, or it sleeps, so impacts do
    /// not change its motion.
    FlyingIndex find(BodyIndex body, bool isObstacle);
    FlyingBody& operator[](FlyingIndex number) { return bodies_[number]; }
    const FlyingBody& operator[](FlyingIndex number) const { return bodies_[number]; }
    /// The number of a body; none if it does not take part.
    FlyingIndex numberOf(BodyIndex body) const { return numberOf_[body]; }

    /// Adds the velocity that the closed form of its flight lacks at this time: with varying fields it leads to the
    /// right place, but only nearly to the right velocity.
    void addFieldsAt(FlyingIndex number, BodyMotion& motion, double time);
    /// Ends a flight at an impact: the body arrives in one state, and goes on in another.
    void depart(FlyingIndex number, const BodyMotion& arrived, const BodyMotion& departing, double time);
    /// Ends a flight before an impact that cannot be solved in this step. The body stays there until the step ends, and
    /// keeps its velocity and its energy: the step that follows solves the impact.
    void stop(FlyingIndex number, double time);

    /// Can impacts change the motion of this body: is it dynamic, not stopped, and not left to the solver?
    bool canFly(FlyingIndex number) const;
    void unite(FlyingIndex a, FlyingIndex b);
    void leaveGroup(FlyingIndex number) { bodies_[first(number)].isLeft = true; }
    /// Of the body's group.
    ImpactWork& workOf(FlyingIndex number) { return bodies_[first(number)].work; }
    const ImpactWork& workOf(FlyingIndex number) const { return bodies_[first(number)].work; }
    bool isLeft(FlyingIndex number) const { return bodies_[first(number)].isLeft; }

    /// Stores the states at the step's end of all bodies that were hit, and adds their trajectories.
    void store(Trajectories& trajectories);

private:
    FlyingIndex first(FlyingIndex number) const;
    void storeBody(FlyingBody& body, const BodyMotion& end);
    void flyToEnd(FlyingBody& body);
    void renewFields(FlyingBody& body);
    FlyingFields* fieldsOf(const FlyingBody& body) { return body.fields == none ? nullptr : &fields_[body.fields]; }

    ImpactStores& stores_;
    double dt_;
    StepList<FlyingBody> bodies_;
    StepList<FlyingFields> fields_;
    StepList<std::pair<FlyingIndex, BodyMotion>> waiting_;  ///< the states of bodies that were stopped
    StepList<FlyingIndex> numberOf_;                        ///< of each body, none if it does not take part
    StepList<TrajectorySegment> segments_;
};

}  // namespace plumb
