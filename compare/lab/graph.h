// SPDX-License-Identifier: MIT
// What is in a graph?
#pragma once
#include <string>
#include <vector>

namespace plumb::compare {

struct Point {
    double x = 0, y = 0;  ///< NaN for y breaks the line
};

/// In all graphs of a lab, curves with the same name have the same colour. A curve with an engine's name has the
/// engine's colour.
struct Curve {
    std::string name{};
    std::vector<Point> points{};  ///< sorted by rising x
    std::string note{};           ///< shown beside the name: "slope 1.02"
    bool theory = false;          ///< true for an expected curve, which is drawn as a thin dotted line
};

struct Axis {
    std::string label{};       ///< "height"
    std::string unit{};        ///< "m"; empty for a plain number
    bool logarithmic = false;  ///< then values that are not positive are left out
};

struct Graph {
    std::string title{};
    Axis x{}, y{};
    std::vector<Curve> curves{};
};

}  // namespace plumb::compare
