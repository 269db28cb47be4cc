// SPDX-License-Identifier: MIT
// How hard does the solver try?
#pragma once

namespace plumb {

struct SolverSettings {
    int subSteps = 4;  ///< 1 to 64; each step is solved in as many parts [-]
    double contactFrequency =
        30;  ///< of contacts, twice that with what is fixed; at most 1/4 of the sub-step rate [Hz]
    double contactDampingRatio = 10;  ///< far over critical: overlap is pushed out without a bounce [-]
    double contactPushSpeed = 3;      ///< the fastest that overlap is pushed out [m/s]
    double sleepSpeed = 0.05;         ///< slower than this everywhere on it, a body counts as still [m/s]
    double sleepTime = 0.5;           ///< still for as long as this, an island falls asleep [s]
    /// Machines of up to so many joints are solved at once: exactly, at some 2 to 6 us a joint and step. Larger ones,
    /// and what is woven as cloth is, are swept joint by joint: chains of plain hinges in a seventh of the time, chains
    /// of hinges with limits in 0.64 of it, and they give under heavy loads. 0: all are swept [-]
    int jointsAtOnce = 1000000;
    int lanes = 16;  ///< at most so many contacts are solved side by side, as the machine can: 1, 4, 8 or 16; the same
                     ///< bits for each [-]
};

}  // namespace plumb
