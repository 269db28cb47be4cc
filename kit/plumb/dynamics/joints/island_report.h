// SPDX-License-Identifier: MIT
// What have the rows of joints given in a pass? It is told to those who keep accounts: the work of a joint cannot be
// seen from outside, because its impulses never become forces on the bodies' records.
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/island_numbers.h>

namespace plumb {

/// After a pass: tells the observer the rows of all joints of the active islands.
void reportRows(const IslandNumbers& numbers, StepObserver& observer);
/// The momentum that the joints of the active islands have given to their bodies. Among themselves they only pass it
/// on, so all of it came from fixed bodies [N s].
Vec2 givenMomentum(const IslandNumbers& numbers);

}  // namespace plumb
