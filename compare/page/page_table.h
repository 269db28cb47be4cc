// SPDX-License-Identifier: MIT
// What is a table of a page, and does it agree with what was measured?
#pragma once
#include <string>
#include <vector>

namespace plumb::compare {

struct PageTable {
    std::vector<std::string> head;               ///< one cell for each column
    std::vector<std::vector<std::string>> rows;  ///< each has as many cells as the head
};

std::string markdown(const PageTable& table);

/// The first table of a text; empty if there is none.
PageTable tableOf(const std::string& text);

/// How far a cell may differ from what was measured.
enum class Exactness {
    ToTheDigit,
    WithinTwo,  ///< each number to a factor of two: for an engine that another compiler built
    Unseen,     ///< not compared
};

/// The rows of a page's table that differ from what was measured, one sentence for each. columns: how exact each column
/// has to be. If the head or the number of rows differs, there is one sentence for the whole table.
std::vector<std::string> differences(const PageTable& page, const PageTable& measured,
                                     const std::vector<Exactness>& columns);

}  // namespace plumb::compare
