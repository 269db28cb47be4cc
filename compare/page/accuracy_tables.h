// SPDX-License-Identifier: MIT
// What do pages say of how true each engine is?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/page/blocks.h>
#include <compare/page/page_table.h>

namespace plumb::compare {

struct AccuracyTable {
    std::string name;                  ///< of its block
    std::vector<std::string> engines;  ///< of each column; empty for a column that tells what is measured
    PageTable table;
};

/// The engines that have a column in each of them.
std::vector<std::string> accuracyEngines();

/// Those of whose scenes all were run:
///   distances  error_max of each scene that has a closed form
///   tiles      how often something catches on flush tiles
///   joints     gaps of joints, and energy that is lost where none should be
///   accuracy   one line of each, for the front page
/// An engine that was not run has empty cells.
std::vector<AccuracyTable> accuracyTables(std::span<const SceneResult> results);

std::vector<Block> blocksOf(std::span<const AccuracyTable> tables);

/// What of a page's blocks is not what was measured: Plumb's columns to the digit, those of engines that each
/// build has within a factor of two, others not at all; and any block that is not what its command wrote. A sentence
/// each.
std::vector<std::string> pageFaults(const std::string& page, std::span<const AccuracyTable> tables);

}  // namespace plumb::compare
