// SPDX-License-Identifier: MIT
#include <compare/scene/random/draw.h>

#include <algorithm>

#include <plumb/math/logarithm.h>
#include <plumb/math/trig.h>

namespace plumb::compare {

double Draw::logUniform(double low, double high) {
    const double exponent = uniform(0, 1) * logarithm(high / low);
    return std::clamp(low * exponential(exponent), low, high);
}

Vec2 Draw::direction() {
    const SinCos turned = sinCos(uniform(0, fullTurn));
    return {turned.cos, turned.sin};
}

}  // namespace plumb::compare
