// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/parts.h>

#include <cmath>

namespace plumb::compare {

std::string engineLabel(const std::string& name) {
    if (name == plumbName) return "Plumb";
    if (!isBox2d(name)) return name;
    return "Box2D " + name.substr(name.find('-') + 1);
}

std::vector<double> geometricSteps(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

}  // namespace plumb::compare
