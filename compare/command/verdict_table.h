// SPDX-License-Identifier: MIT
// How are the verdicts shown in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// One row for each scene, printed as soon as its result is known: verdict, name, error_max of each engine, and how
/// many checks hold. Below it, every check that fails is printed.
class VerdictTable {
public:
    /// engines: the columns, without the closed form. The widest scene name sets the width.
    VerdictTable(std::ostream& out, std::vector<std::string> engines, std::span<const Scene> scenes, bool colour);

    void head() const;
    void row(const SceneResult& result) const;
    /// Prints the answer of the engine under test to the scene's question, what the scene sets for one engine alone,
    /// and where each pair of engines parts.
    void partings(const SceneResult& result) const;
    /// Prints how many scenes hold, fail, and were not judged.
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
