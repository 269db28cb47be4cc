// SPDX-License-Identifier: MIT
// Which discs slide or roll along a chain during the step, and where to?
//
// The solver uses the normal of the step's start until its end. On a curve it would turn the velocity of what slides by
// the wrong angle, and take the share (v dt / R)^2 of its energy in each step. A disc that slides without friction
// or rolls, and touches nothing but a chain at rest, has a closed form (see chain_path.h). The solver computes its
// contacts as before, so that they have impulses and events; its place and velocity are those of the closed form.
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The state of a disc at the end of the step.
struct ChainSlideEnd {
    BodyIndex body = noBody;
    BodyMotion motion;
};

/// Call this before the solver moves the bodies, after the impacts. The solver will not move the discs that are found.
StepList<ChainSlideEnd> findChainSlides(BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt);

/// Call this after the solver: moves the discs to the ends of their slides. observer may be null.
void moveAlongChains(BodyStore& bodies, const StepList<ChainSlideEnd>& slides, double dt, StepObserver* observer);

}  // namespace plumb
