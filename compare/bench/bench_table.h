// SPDX-License-Identifier: MIT
// How are measured times shown in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// "1.23 ms", or "12.3 us" below 0.1 ms; three significant digits.
std::string timeText(double milliseconds);

/// "; left out, because a joint opened by more than 1 m or a body was lost: joint_grid". Empty if all scenes count.
std::string leftOutText(const MeanRatio& mean);

/// Prints a row for each engine in each scene, as soon as the scene is measured. At the end, it prints the means, how
/// times grow with the number of bodies, and how much time each part of a step takes.
class BenchTable {
public:
    /// nameWidth: length of the longest scene name.
    BenchTable(std::ostream& out, std::size_t nameWidth);
    void head() const;
    void rows(const SceneBench& scene) const;
    void summary(std::span<const SceneBench> results) const;

private:
    void row(const SceneBench& scene, const EngineBench& bench) const;

    std::ostream& out_;
    std::size_t nameWidth_;
};

}  // namespace plumb::compare
