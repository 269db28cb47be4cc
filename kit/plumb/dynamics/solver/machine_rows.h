// SPDX-License-Identifier: MIT
// Which conditions does a contact of a machine set, in half a sub-step? See machine_contacts.h.
#pragma once
#include <array>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/solver/machine_contacts.h>
#include <plumb/math/detail/mat3.h>

namespace plumb {

/// A unit impulse on a body, x, y, turning, and the answer of all bodies of its part.
struct MachineEnd {
    std::uint32_t part = none, node = 0;
    BodyIndex body = noBody;
    Vec3 push{};
    std::size_t answer = 0;
};
struct MachineRow {
    MachineEnd a, b;
    double inverseMass = 0;     ///< change of the row's speed by a unit of its impulse; 0: there is no such row
    double ownInverseMass = 0;  ///< the same, if its bodies had no joints
    double fixedSpeed = 0;      ///< of bodies that cannot be pushed, and of the surfaces [m/s]
    double given = 0;           ///< impulse of the half before, which this half may take back [N s, N m s]
    double impulse = 0;         ///< now
    double limit = 0;           ///< of friction and rolling, of both halves together
};
/// The rows of a contact: two normals, two tangents, rolling.
struct MachineRows {
    std::array<MachineRow, 5> row;
    std::array<double, 2> separation{};
    double friction = 0, rollingArm = 0;
    double softMass = 0;  ///< the greatest effective mass with which overlap is pushed out [kg]
    bool ground = false;
};

/// The rows of a contact that is hidden from its lane.
MachineRows rowsOf(const MachineContact& machine, const ContactGraph& graph, const ContactRecord& contact,
                   const BodyStore& bodies, const JointHalf& half);
/// Puts masses and impulses back into the lane.
void storeRows(const MachineContact& machine, const MachineRows& rows, ContactGraph& graph,
               const ContactRecord& contact, const JointHalf& half);

}  // namespace plumb
