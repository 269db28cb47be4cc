// SPDX-License-Identifier: MIT
// What do joints do in a step?
//
// A world calls the code of joints through this table, which its first joint sets. So the linker removes all code of
// joints from a program without joints. That is the table's only use: a page in a browser loads what is left.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/jointed/joint_bounces.h>
#include <plumb/dynamics/jointed/joint_contacts.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

struct JointStore;
struct JointIslands;
struct JointStores;
struct BodyMove;

struct JointPhases {
    /// Before the sub-steps of a step of dt [s]: finds the islands again if the joints have changed.
    void (*prepare)(const JointStores& stores, double dt);
    /// Takes the islands into their lanes. mayFly: those that have no contacts go into batches of their own.
    void (*load)(const JointStores& stores, double dt, bool mayFly);
    /// Half a sub-step of a batch whose islands have no contacts (see joint_islands.h). Other calls leave it out.
    void (*fly)(const JointStores& stores, JointBatch& batch, const JointHalf& half);
    /// Takes in what others have done to the bodies in lanes, and lets the forces of half a sub-step act on them.
    void (*kick)(const JointStores& stores, const JointHalf& half);
    /// After all bodies have moved: moves the bodies of some batches.
    void (*move)(const JointStores& stores, std::span<JointBatch> batches, double h);
    /// kicked: after kick; else it does that first.
    void (*solve)(const JointStores& stores, const JointHalf& half, bool kicked);
    /// Returns the contacts that bounce and have a jointed body, and keeps the solver from bouncing them again.
    std::vector<BounceGroup> (*takeBounces)(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                            const JointIslands& islands);
    /// Applies the impulses of those bounces that meet in the coming sub-step of h [s].
    void (*bounce)(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                   const std::vector<BounceGroup>& bounces, double h);
    // See joint_contacts.h.
    void (*findJointedContacts)(const JointStores& stores, JointedContacts& jointed);
    void (*startContacts)(const JointStores& stores, const JointHalf& half, JointedContacts& jointed);
    void (*respondToContacts)(const JointStores& stores, const JointHalf& half, const JointedContacts& jointed);
    /// For an island that is not swept: applies an impulse (x, y, turning) to one body, and the reactions of its
    /// joints; or tells by how much that would change the body's velocity.
    void (*push)(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse);
    Vec3 (*responseOf)(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse);
    /// By how much its worst joint has opened since the step's start [m].
    double (*opening)(const JointIsland& island);
    /// After such impulses: removes the errors that they cause in the joints' held rows.
    void (*hold)(const JointStores& stores, JointIsland& island, double h);
    /// At the end of the step: stores the loads of the joints, and adds the moves of all bodies in lanes.
    void (*store)(const JointStores& stores, std::vector<std::pair<BodyIndex, BodyMove>>& moves);
    double (*springEnergy)(const JointStore& joints, const BodyStore& bodies);  ///< [J]
};

extern const JointPhases jointPhases;

}  // namespace plumb
