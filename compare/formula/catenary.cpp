// SPDX-License-Identifier: MIT
#include <compare/formula/catenary.h>

#include <cmath>

namespace plumb::compare {
namespace {

/// The vector along a link.
Vec2 stepOf(const HungChain& chain, int link, double pull) {
    const Vec2 along(pull, link + 0.5 - 0.5 * chain.links);
    return chain.linkLength / along.norm() * along;
}

double spanAt(const HungChain& chain, double pull) {
    double span = 0;
    for (int link = 0; link < chain.links; ++link) span += stepOf(chain, link, pull).x();
    return span;
}

}  // namespace

std::vector<Vec2> hingesOf(const HungChain& chain) {
    double low = 0, high = 1;
    while (spanAt(chain, high) < chain.span) high *= 2;
    for (double middle = high / 2; middle > low && middle < high; middle = (low + high) / 2)
        (spanAt(chain, middle) < chain.span ? low : high) = middle;
    std::vector<Vec2> hinges{chain.left};
    for (int link = 0; link < chain.links; ++link) hinges.push_back(hinges.back() + stepOf(chain, link, high));
    return hinges;
}

}  // namespace plumb::compare
