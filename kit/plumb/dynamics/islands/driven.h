// SPDX-License-Identifier: MIT
// What drives a body, so that it may not sleep although it is slow?
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// Does an awake kinematic body touch this body, or is it joined to it?
bool isCarried(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body);
/// Does a belt move the body (see Material.surfaceSpeed), or a motor that runs? A body that such a drive cannot move,
/// as something is in its way, is not driven.
bool isDriven(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints,
              const SolverSettings& settings, BodyIndex body);

}  // namespace plumb
