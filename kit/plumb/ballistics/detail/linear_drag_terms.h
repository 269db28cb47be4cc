// SPDX-License-Identifier: MIT
// What does linear drag leave of a launch, and make of a constant force?
#pragma once

namespace plumb::detail {

/// x = u reach + a sag, x' = u decay + a reach: of launch velocity u and acceleration at rest a.
struct LinearDragTerms {
    double decay;  ///< e^(-k t) [-]
    double reach;  ///< (1 - e^(-k t)) / k [s]
    double sag;    ///< (t - reach) / k [s^2]
};

LinearDragTerms linearDragTerms(double rate, double time);

}  // namespace plumb::detail
