// SPDX-License-Identifier: MIT
// What happens in a step to bodies that fly, and meet one other at a time? Each impact is solved at the moment it
// happens, by the closed form, in the order of time. Everything else is left to the solver.
//
// Every pair of bodies that may meet has a prediction of its next impact, in a queue. The earliest one is solved, and
// the pairs of its two bodies are predicted again. So the work grows with the number of impacts and with the pairs that
// a body has, not with the size of the crowd.
// Source: Alder and Wainwright, "Studies in molecular dynamics", J. Chem. Phys. 31 (1959) 459; Mirtich, "Impulse-based
// dynamic simulation of rigid body systems", 1996, ch. 2.
//
// The work of a step is bounded: by the number of impacts of one pair, and by the number of predictions for the pairs
// of a group of bodies that have hit each other. A group that needs more is left to the solver, from the start of the
// step: its bodies come to rest on each other, and would bounce infinitely often in a finite time. Each group has a
// bound of its own, so that what happens elsewhere in the world does not change its motion.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/impacts/flying_bodies.h>

namespace plumb {

/// Moves the bodies whose contacts in this step are all isolated impacts, and removes those contacts from the solver's
/// slots. All other contacts stay in the solver. Adds the ways of those bodies to trajectories. Impacts
/// faster than hitSpeed [m/s] are hits.
TouchEvents solveIsolatedImpacts(ImpactStores& stores, Trajectories& trajectories, double dt, double hitSpeed);

}  // namespace plumb
