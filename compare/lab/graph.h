// SPDX-License-Identifier: MIT
// What does a graph hold that anyone may draw?
#pragma once
#include <string>
#include <vector>

namespace plumb::compare {

struct Point {
    double x = 0, y = 0;  ///< NaN for y breaks the line
};

/// In all graphs of a lab the same name has the same colour; an engine's name has the engine's.
struct Curve {
    std::string name{};
    std::vector<Point> points{};  ///< by rising x
    std::string note{};           ///< beside the name: "slope 1.02"
    bool theory = false;          ///< what is expected, drawn as a thin dotted line
};

struct Axis {
    std::string label{};       ///< "height"
    std::string unit{};        ///< "m"; empty for a plain number
    bool logarithmic = false;  ///< what is not positive is then left out
};

struct Graph {
    std::string title{};
    Axis x{}, y{};
    std::vector<Curve> curves{};
};

}  // namespace plumb::compare
