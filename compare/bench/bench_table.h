// SPDX-License-Identifier: MIT
// How do measured times look in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// "1.23 ms", or "12.3 us" below 0.1 ms; three digits that count.
std::string timeText(double milliseconds);

/// A row for each engine in each scene, as soon as the scene is measured; at the end the means, how times grow, and
/// where a step goes.
class BenchTable {
public:
    /// nameWidth: of the longest scene.
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
