// SPDX-License-Identifier: MIT
// When does something happen to a quantity that is known at moments only?
#pragma once
#include <optional>
#include <vector>

#include <compare/scene/answer.h>

namespace plumb::compare {

/// A quantity through a run. Between two moments it is the cubic with the values and slopes of both (Hermite), or a
/// line where slopes are not known. Values that are not numbers are passed over.
struct Course {
    std::vector<double> time{};   ///< [moment], never falls; two that are equal: a jump [s]
    std::vector<double> value{};  ///< [moment]
    std::vector<double> slope{};  ///< [moment] its rate of change; empty: not known [1/s]
};

/// At a time within the run; at a jump, just before it.
double valueAt(const Course& course, double time);

/// When it happens [s]; none if it does not within the run.
std::optional<double> timeOf(const Course& course, const Happening& event);

/// The mean time from one passage through the middle of what it reaches to the next but one; from a single half, twice
/// its time. None for fewer than two passages [s].
std::optional<double> periodOf(const Course& course);

}  // namespace plumb::compare
