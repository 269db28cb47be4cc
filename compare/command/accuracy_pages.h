// SPDX-License-Identifier: MIT
// Do the pages agree with what is measured?
#pragma once
#include <iosfwd>
#include <span>

#include <compare/command/arguments.h>

namespace plumb::compare {

class AccuracyPages {
public:
    /// Throws std::invalid_argument if a page cannot be read or has no table of accuracy, if the arguments change how
    /// the scenes run, or if a page is to be written and not all engines run.
    AccuracyPages(const Arguments& arguments, const std::vector<Engine>& engines);

    /// Writes the tables, and compares them with the pages to be verified. False if a page differs; each difference is
    /// printed on a line.
    bool hold(std::span<const SceneResult> results, std::ostream& out) const;

private:
    PageOptions pages_;
};

}  // namespace plumb::compare
