// SPDX-License-Identifier: MIT
// How is one contact solved, apart from its batch?
#pragma once
#include <plumb/dynamics/contacts/lanes/contact_solver.h>

namespace plumb {

/// The impulses of the first half of the sub-step, which the second half may take back; 0 during the first half.
struct ContactImpulses {
    float normal[2] = {0, 0}, tangent[2] = {0, 0};
    float roll = 0;
    float totalNormal[2] = {0, 0}, totalTangent[2] = {0, 0};  ///< until then, since the step's start
};
/// The present impulses of a lane.
ContactImpulses impulsesOf(const ContactBatch& batch, std::size_t lane);
/// The separation of a point at the bodies' present displacements [m].
float separationNow(const ContactBatch& batch, std::size_t point, std::size_t lane,
                    const SolverDisplacement* displacement);
/// Takes back what a lane has added since it had these impulses.
void takeBackLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactImpulses& start);
/// Solves one lane once more, after solve or relax. solved: the impulses before relax.
void solveLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass);
void relaxLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass,
               const ContactImpulses& solved);

}  // namespace plumb
