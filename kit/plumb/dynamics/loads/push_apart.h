// SPDX-License-Identifier: MIT
// How do bodies get apart that were put into each other?
//
// They are shifted, at the start of a step, and get no velocity. How far each one goes is found as contacts find
// velocities: by the contact solver, with shifts in place of speeds. What they push takes part from the next sweep on,
// so that nothing is pushed into something else.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// Shifts the bodies of ContactStore.overlaps, and what they push, in a step of dt [s]. Uses the contacts as the last
/// step has left them.
void pushApart(const ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies,
               const SolverSettings& settings, double dt);

}  // namespace plumb
