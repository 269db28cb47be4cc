// SPDX-License-Identifier: MIT
// What is a table of a page, and does one that stands there say what was measured?
#pragma once
#include <string>
#include <vector>

namespace plumb::compare {

struct PageTable {
    std::vector<std::string> head;               ///< of each column
    std::vector<std::vector<std::string>> rows;  ///< as many cells as the head has
};

std::string markdown(const PageTable& table);

/// The first table of a text; empty when there is none.
PageTable tableOf(const std::string& text);

/// How far a cell may differ from what was measured.
enum class Exactness {
    ToTheDigit,
    WithinTwo,  ///< each number by a factor of two: an engine that another compiler built
    Unseen,     ///< the engine is not here
};

/// The rows of a table that stands on a page, but that do not say what was measured, one sentence each. columns: how
/// exact each column has to be; what has another head or another number of rows is told of as a whole.
std::vector<std::string> differences(const PageTable& page, const PageTable& measured,
                                     const std::vector<Exactness>& columns);

}  // namespace plumb::compare
