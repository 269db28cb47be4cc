// SPDX-License-Identifier: MIT
#include <compare/closed_form/incline.h>

#include <algorithm>
#include <cmath>

namespace plumb::compare {

double slidingAcceleration(const Incline& incline, double friction) {
    return incline.gravity * std::max(0.0, std::sin(incline.angle) - friction * std::cos(incline.angle));
}

double rollingAcceleration(const Incline& incline, double inertiaRatio) {
    return incline.gravity * std::sin(incline.angle) / (1 + inertiaRatio);
}

}  // namespace plumb::compare
