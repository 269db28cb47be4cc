// SPDX-License-Identifier: MIT
// How do contacts and joints of the same bodies act together?
//
// Contacts are solved in their lanes, like all others. They see a jointed body with the mass with which its island
// responds (see joints/lanes/island_response_wide.h): the wheel of a cart of a ton with half a ton. Their impulses are
// then added to the velocities without the joints' impulses, and the joints are solved again from there. So joints hold
// exactly after every pass, and a contact that pushes a wheel pushes the cart.
// n bodies of an island that meet contacts respond to each other, too. For any K, x^T K x <= n sum x_i^T K_ii x_i: with
// n times their own responses, no pass can add energy. A mass that is too small costs some passes; one that is twice
// too large makes the solution explode. While a suspension is at a stop, its wheel has the cart's mass; else its own.
// If the joints' response opens or closes a stop, the contacts of this island are taken back and solved again with the
// new masses. But a stop that opens because nothing pushes there any more is as it should be. Source: splitting of
// masses: Tonge, Benevolenski, Voroshilov, "Mass splitting for jitter-free parallel rigid body simulation", ACM Trans.
// Graph. 31 (2012) 105. Test: "a cart of a ton on wheels of a kilogram comes to rest"
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/lanes/single_lane.h>
#include <plumb/dynamics/jointed/joint_solver.h>

namespace plumb {

class JointedContacts {
public:
    /// At the start of a step: finds the contacts that may have to be solved again.
    void find(const JointStores& stores, std::span<const JointIsland> islands);
    /// Before contacts are solved in a half: lets them see the right masses.
    void start(JointStores& stores, std::span<JointBatch> batches, bool isFirst);
    /// After contacts are solved: lets the joints respond to their impulses, and notes the loads of the joints.
    void respond(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn);

private:
    /// A contact that may have to be solved again, and its impulses before this half.
    struct Jointed {
        JointBatch* batch = nullptr;
        std::size_t lane = 0;  ///< in that batch
        ContactIndex contact = none;
        ContactImpulses start{};
    };

    bool respondOnce(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn);
    void solveAgain(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn);
    void setMasses(JointStores& stores) const;
    template <class Visit>
    void forEachChanged(const JointStores& stores, Visit&& visit) const;

    std::vector<Jointed> some_;      ///< those that may have to be solved again
    std::vector<ContactBody> seen_;  ///< bodies that contacts shall see with other masses
};

}  // namespace plumb
