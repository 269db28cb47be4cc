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
/// null. An infinite one is null, too, because JSON has no number for it; its check does not pass.
/// The pass of a scene or lab is null if nothing was judged in it. The last pass is false if a scene or lab fails, else
/// true if one was judged, else null.
std::string verdictJson(std::span<const SceneResult> results, std::span<const LabResult> labs = {});

}  // namespace plumb::compare
