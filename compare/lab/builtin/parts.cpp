// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/parts.h>

#include <cmath>

namespace plumb::compare {

std::string engineLabel(const std::string& name) {
    if (name == plumbName) return "Plumb";
    if (!isBox2d(name)) return name;
    const std::string version = name.substr(name.find('-') + 1);
    const std::size_t flag = version.find(" bullets");
    return "Box2D " + version.substr(0, flag) + (flag == std::string::npos ? "" : " with bullets");
}

std::vector<double> geometricSteps(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

}  // namespace plumb::compare
