// SPDX-License-Identifier: MIT
// How exactly are the worked numbers of closed forms known, and what does the comparison work out?
#pragma once
#include <vector>

#include <compare/closed_form/oracle.h>

namespace plumb::compare {

inline constexpr double digits = 6e-11;  // they have ten decimals

/// The flights of the closed form's motion at a place.
inline std::vector<Flight> flightsIn(const Scene& scene, std::size_t place) {
    return std::get<PiecewiseMotion>(workedOut(scene).bodies.at(place)).flights;
}

}  // namespace plumb::compare
