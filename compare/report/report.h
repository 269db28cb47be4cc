// SPDX-License-Identifier: MIT
// How are the results shown to a person?
#pragma once
#include <filesystem>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/lab/lab.h>

namespace plumb::compare {

/// Writes folder/index.html: one file that opens from disk without a network. Makes the folder.
/// Throws std::runtime_error if it cannot be written.
void writeReport(const std::vector<SceneResult>& results, const std::filesystem::path& folder,
                 const std::vector<LabResult>& labs = {});

/// Writes folder/<scene>.<engine>.csv, one row per tick, with units in the head. The columns are t; for each moving
/// body x, y, angle, vx, vy and spin, and its distance to the closed form if that was run; energies by kind; probes;
/// the force in each joint; the largest distance to the closed form. A cell is empty if there is no number. Makes the
/// folder. Throws std::runtime_error if a file cannot be written.
void writeCsv(const std::vector<SceneResult>& results, const std::filesystem::path& folder);

/// Writes folder/<lab>.csv, one row per point of its curves: graph, curve, x, y. Makes the folder. Throws as writeCsv
/// does.
void writeLabCsv(const std::vector<LabResult>& results, const std::filesystem::path& folder);

}  // namespace plumb::compare
