// SPDX-License-Identifier: MIT
// How do other programs read the verdicts?
#pragma once
#include <span>
#include <string>

#include <compare/check/verdict.h>
#include <compare/lab/lab.h>

namespace plumb::compare {

/// {"schema":1,"scenes":[{"name","dt","steps","engines":{"<engine>":{"metrics":{"<metric>":number}}},
///   "checks":[{"check","engine","metric","value","limit","pass"}],"pass"}],
///   "labs":[{"name","checks":[{"check","value","limit","pass"}],"pass"}],"pass"}
/// An engine that cannot build a scene also has "unsupported" with the reason. A metric or value that does not exist is
/// null, and so is one without bound, for which JSON has no number: its check does not pass.
/// The pass of a scene or lab of which nothing was judged is null, too. The last one is false if one fails, else true
/// if one was judged, else null.
std::string verdictJson(std::span<const SceneResult> results, std::span<const LabResult> labs = {});

}  // namespace plumb::compare
