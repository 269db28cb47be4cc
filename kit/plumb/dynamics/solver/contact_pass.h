// SPDX-License-Identifier: MIT
// How firm are contacts in a sub-step?
#pragma once
#include <algorithm>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// The speed at which contacts push out overlap that their load does not explain [m/s]. Faster, crowds that were put
/// into each other would burst; what is deep is shifted instead (overlaps.h).
inline constexpr float contactLift = 0.1f;

struct ContactPasses {
    ContactPass loose, ground;

    /// Of an entry of ContactGraph.colours. Contacts with fixed bodies have twice the frequency: the ground does not
    /// move.
    const ContactPass& of(std::size_t index) const {
        const int colour = colourAt(index);
        return colour >= fixedColour && colour != overflowColour ? ground : loose;
    }
};

inline ContactPass contactPass(const SolverSettings& settings, double frequency, double h) {
    const Softness soft = softness(std::min(frequency, 0.25 / h), settings.contactDampingRatio, h);
    return {static_cast<float>(1 / h), soft, contactLift, soft.impulseScale / soft.massScale};
}

/// h: the sub-step [s].
inline ContactPasses passesOf(const SolverSettings& settings, double h) {
    return {contactPass(settings, settings.contactFrequency, h),
            contactPass(settings, 2 * settings.contactFrequency, h)};
}

}  // namespace plumb
