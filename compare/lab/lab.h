// SPDX-License-Identifier: MIT
// What comes of an experiment in which one quantity is varied?
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/engine/engine.h>
#include <compare/lab/graph.h>

namespace plumb::compare {

enum class Bound { AtMost, AtLeast };

/// What must hold of a number that the lab measures.
struct LabCheck {
    std::string name{};  ///< snake_case, with dots where there are several of a kind: "order.rk4"
    Bound bound = Bound::AtMost;
    double limit = 0;
    std::string unit{};    ///< of value and limit; empty for a plain number
    std::string reason{};  ///< why this limit
    std::string engine{};  ///< judged only where this engine was run; empty: always
};

struct LabRun {
    std::vector<Graph> graphs{};
    std::map<std::string, double> values{};  ///< by the name of their check
    std::vector<std::string> seen{};         ///< sentences with the numbers that were measured
};

struct Lab {
    std::string name{};      ///< snake_case, no scene's
    std::string question{};  ///< what it asks, one sentence
    std::string varied{};    ///< "frames a second, from 24 to 240"
    std::vector<LabCheck> checks{};
    /// engines: those asked for, without the closed form. What is the lab's own subject is run in any case.
    std::function<LabRun(const std::vector<Engine>& engines)> run{};
};

struct LabOutcome {
    LabCheck check{};
    std::optional<double> value{};  ///< empty where it was not measured
    bool pass = false;
};

struct LabResult {
    Lab lab{};
    LabRun run{};
    std::vector<LabOutcome> outcomes{};  ///< empty where no check binds an engine that was run
    Verdict verdict = Verdict::NotJudged;
};

/// Runs a lab and judges its checks: one whose value is missing or no number does not hold.
/// asked: names of engines; empty: all of the given ones.
LabResult runLab(const Lab& lab, const std::vector<std::string>& asked, const std::vector<Engine>& engines);

}  // namespace plumb::compare
