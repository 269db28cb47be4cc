// SPDX-License-Identifier: MIT
// What do the pages say about the accuracy of each engine?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/page/blocks.h>
#include <compare/page/page_table.h>

namespace plumb::compare {

struct AccuracyTable {
    std::string name;                  ///< name of its block
    std::vector<std::string> engines;  ///< the engine of each column; empty for a column that says what is measured
    PageTable table;
};

/// The engines that have a column in each table.
std::vector<std::string> accuracyEngines();

/// The tables for which all scenes were run:
///   distances  error_max of each scene that has a closed form
///   tiles      how often something catches on flush tiles
///   joints     gaps of joints, and energy that is lost where none should be
///   accuracy   one line of each, for the front page
///   lecture    periods, ranges and times to fall beside the formulas of a first lecture: see lecture_table.h
/// An engine that was not run has empty cells.
std::vector<AccuracyTable> accuracyTables(std::span<const SceneResult> results);

std::vector<Block> blocksOf(std::span<const AccuracyTable> tables);

/// The differences between a page's blocks and what was measured, one sentence for each. Plumb's columns are compared
/// to the digit, those of engines that are in every build to a factor of two, and others not at all. A block that is
/// not as its command wrote it is also a difference.
std::vector<std::string> pageFaults(const std::string& page, std::span<const AccuracyTable> tables);

}  // namespace plumb::compare
