// SPDX-License-Identifier: MIT
#include <compare/formula/ballistic_pendulum.h>

#include <cmath>

namespace plumb::compare {

double riseOf(const BallisticPendulum& pendulum) {
    const double together = pendulum.bullet * pendulum.speed / (pendulum.bullet + pendulum.block);
    return together * together / (2 * pendulum.gravity);
}

double amplitudeOf(const BallisticPendulum& pendulum) {
    return 2 * std::asin(std::sqrt(riseOf(pendulum) / (2 * pendulum.length)));
}

}  // namespace plumb::compare
