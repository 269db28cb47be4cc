// SPDX-License-Identifier: MIT
// Do the pages say what is measured?
#pragma once
#include <iosfwd>
#include <span>

#include <compare/command/arguments.h>

namespace plumb::compare {

class AccuracyPages {
public:
    /// Throws std::invalid_argument when a page cannot be read or has no table of accuracy, when the scenes shall run
    /// otherwise than they are, or when a page shall be written and not all engines run.
    AccuracyPages(const Arguments& arguments, const std::vector<Engine>& engines);

    /// Writes the tables, and compares them; false when a page that is to be verified says something else, which is
    /// told line by line.
    bool hold(std::span<const SceneResult> results, std::ostream& out) const;

private:
    PageOptions pages_;
};

}  // namespace plumb::compare
