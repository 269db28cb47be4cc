// SPDX-License-Identifier: MIT
// How does a person read the verdicts in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// A row a scene, written as soon as its result is there: verdict, name, error_max of each engine, how many checks
/// hold, and below it every check that fails.
class VerdictTable {
public:
    /// engines: the columns, without the closed form. The widest scene name sets the width.
    VerdictTable(std::ostream& out, std::vector<std::string> engines, std::span<const Scene> scenes, bool colour);

    void head() const;
    void row(const SceneResult& result) const;
    /// What the engine under test answers to its question, and where each two of its engines part.
    void partings(const SceneResult& result) const;
    /// How many scenes hold, fail, and were not judged.
    void summary(std::span<const SceneResult> results) const;

private:
    std::ostream& out_;
    std::vector<std::string> engines_;
    std::size_t nameWidth_;
    bool colour_;
};

/// The failed check in words: "exact: plumb error_max is 0.002 m, over 0.001 m: reason".
std::string failureText(const Scene& scene, const Outcome& outcome);

}  // namespace plumb::compare
