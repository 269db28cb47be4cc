// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/parts.h>

#include <cmath>

namespace plumb::compare {

Engine withOneSubStep(const Engine& engine) {
    return engine.withOneSubStep ? engine.withOneSubStep() : engine;
}

std::vector<double> geometricSteps(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

}  // namespace plumb::compare
