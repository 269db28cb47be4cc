// SPDX-License-Identifier: MIT
// How do bodies get apart that were put into each other?
//
// An editor or a spawner may put bodies where others are. Contacts that push such bodies out give them speed, and in a
// crowd the speeds add up: it bursts. So the bodies are shifted instead, at the start of a step, and get no velocity.
// How far each one goes is found as contacts find velocities: by the contact solver, with shifts in place of speeds.
// What a load presses in is not counted as overlap: contacts are springs, and hold it.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// Shifts bodies that overlap, in a step of dt [s]. Uses the contacts as the last step has left them.
void pushApart(const ContactGraph& graph, BodyStore& bodies, const SolverSettings& settings, double dt);

}  // namespace plumb
