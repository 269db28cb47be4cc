// SPDX-License-Identifier: MIT
// Which functions do several labs share?
#pragma once
#include <cmath>
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// The engine with one sub-step. An engine without sub-steps is returned as it is.
inline Engine withOneSubStep(const Engine& engine) {
    return engine.withOneSubStep ? engine.withOneSubStep() : engine;
}

/// count values from low to high; each is the same multiple of the one before.
inline std::vector<double> geometricSteps(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

}  // namespace plumb::compare
