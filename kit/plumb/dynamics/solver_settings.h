// SPDX-License-Identifier: MIT
// Which settings control the solver's accuracy and speed, and when bodies sleep?
#pragma once

namespace plumb {

struct SolverSettings {
    int subSteps = 4;  ///< 1 to 64: the number of parts in which each step is solved [-]
    double contactFrequency =
        30;  ///< of contacts as springs, doubled with fixed bodies; at most 1/4 of the sub-step rate [Hz]
    double contactDampingRatio = 10;  ///< far over critical: overlap is pushed out without a bounce [-]
    double contactPushSpeed = 3;      ///< greatest speed at which overlap is pushed out, see rest.md [m/s]
    double sleepSpeed = 0.05;         ///< a body counts as still if all its points are slower than this [m/s]
    double sleepTime = 0.5;           ///< an island falls asleep when it has been still for this time [s]
    int lanes = 16;  ///< most contacts solved in parallel, if the processor can: 1, 4, 8 or 16; all give bitwise equal
                     ///< results [-]
};

}  // namespace plumb
