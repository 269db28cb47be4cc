// SPDX-License-Identifier: MIT
// How long do two shapes go on bouncing that are pressed together?
//
// A bounce at the speed v under the acceleration a takes 2 e v / a, and the next one e times as long. If they all are
// over within the step, the two come to rest on each other, which is the solver's task; otherwise each impact is solved
// by its closed form.
// e restitution [-]
#pragma once

namespace plumb {

/// The time of the first 16 bounces, over that of a bounce that loses nothing: e + e^2 + ... + e^16.
/// T: a float, a double, or a vector of floats
template <class T>
T sumOfBounces(T e) {
    const T e2 = e * e, e4 = e2 * e2, e8 = e4 * e4;
    return (e + e2) * (e2 + 1) * (e4 + 1) * (e8 + 1);
}

}  // namespace plumb
