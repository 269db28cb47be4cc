// SPDX-License-Identifier: MIT
// What is an experiment in which one quantity is varied, and what is its result?
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

/// A condition for a number that the lab measures.
struct LabCheck {
    std::string name{};  ///< snake_case, with dots if there are several of a kind: "order.rk4"
    Bound bound = Bound::AtMost;
    double limit = 0;
    std::string unit{};    ///< of value and limit; empty for a plain number
    std::string reason{};  ///< why this limit
    std::string engine{};  ///< the check is judged only if this engine was run; empty: always
};

struct LabRun {
    std::vector<Graph> graphs{};
    std::map<std::string, double> values{};  ///< the key is the name of the check
    std::vector<std::string> seen{};         ///< sentences with the numbers that were measured
};

struct Lab {
    std::string name{};      ///< snake_case, not the name of a scene
    std::string question{};  ///< one sentence
    std::string varied{};    ///< "frames a second, from 24 to 240"
    std::vector<LabCheck> checks{};
    /// engines: those asked for, without the closed form. The lab always runs its own subject.
    std::function<LabRun(const std::vector<Engine>& engines)> run{};
};

struct LabOutcome {
    LabCheck check{};
    std::optional<double> value{};  ///< empty if it was not measured
    bool pass = false;
};

struct LabResult {
    Lab lab{};
    LabRun run{};
    std::vector<LabOutcome> outcomes{};  ///< empty if no check applies to an engine that was run
    Verdict verdict = Verdict::NotJudged;
};

/// Runs a lab and judges its checks. A check fails if its value is missing or not a number.
/// asked: names of engines; empty: all of the given ones.
LabResult runLab(const Lab& lab, const std::vector<std::string>& asked, const std::vector<Engine>& engines);

}  // namespace plumb::compare
