// SPDX-License-Identifier: MIT
// How does a drawing go to a browser? As numbers and one text, which painter.js reads in the same order.
#pragma once
#include <string>
#include <vector>

#include <games/frame/drawing.h>

namespace plumb::games {

struct MarkRow {
    std::vector<double> numbers;  ///< mark after mark, in the order in which they are painted
    std::string text;             ///< all words, one after another; a mark has the start and the length of its own
};

/// Writes over what the row held.
void writeMarks(const Drawing& drawing, MarkRow& row);

}  // namespace plumb::games
