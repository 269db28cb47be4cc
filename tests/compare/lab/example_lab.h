// SPDX-License-Identifier: MIT
// Which lab has a known outcome?
#pragma once
#include <string>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// Two graphs of one curve y = 2 x at x = 1, 2, 4, the second logarithmic; "slope" is measured as value, and must be at
/// most 2.5; and one sentence.
inline Lab exampleLab(double value) {
    Lab lab{.name = "example_lab",
            .question = "Does </script> end the page?",
            .varied = "x, from 1 to 4",
            .checks = {{.name = "slope", .limit = 2.5, .unit = "m/s", .reason = "it is 2"}}};
    lab.run = [value](const std::vector<Engine>&) {
        const Curve curve{.name = "twice, \"doubled\"", .points = {{1, 2}, {2, 4}, {4, 8}}, .note = "slope 1"};
        return LabRun{.graphs = {{.title = "Even axes", .x = {"time", "s"}, .y = {"way", "m"}, .curves = {curve}},
                                 {.title = "Logarithmic axes",
                                  .x = {"time", "s", true},
                                  .y = {"way", "m", true},
                                  .curves = {curve}}},
                      .values = {{"slope", value}},
                      .seen = {"The way grows by 2 m a second."}};
    };
    return lab;
}

inline LabResult exampleResult(double value) {
    return runLab(exampleLab(value), {}, {});
}

}  // namespace plumb::compare
