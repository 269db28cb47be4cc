// SPDX-License-Identifier: MIT
// Do two shapes bounce that meet while something presses them together?
//
// A bounce at the speed v under the acceleration a takes 2 e v / a, and the next one e times as long.
// - One that is over within the step is none: e v <= a dt / 2, the speed that the acceleration makes of rest in half a
//   step. Else what rests would hop. Everyone who solves an impact asks bounces().
// - If all of them are over within the step, the two come to rest on each other, which is the solver's task; otherwise
//   each impact is solved at its moment, by its closed form: sumOfBounces() tells.
// e restitution [-]
#pragma once

namespace plumb {

/// speed: of the approach [m/s]; resting: a dt / 2 [m/s]. T: a float, a double, or a vector of floats.
template <class T>
auto bounces(T restitution, T speed, T resting) {
    return restitution * speed > resting;
}

/// The time of the first 16 bounces, over that of a bounce that loses nothing: e + e^2 + ... + e^16.
template <class T>
T sumOfBounces(T e) {
    const T e2 = e * e, e4 = e2 * e2, e8 = e4 * e4;
    return (e + e2) * (e2 + 1) * (e4 + 1) * (e8 + 1);
}

}  // namespace plumb
