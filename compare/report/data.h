// SPDX-License-Identifier: MIT
// What does the page know?
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/lab/lab.h>

namespace plumb::compare {

struct ReportSettings {
    /// Numbers of all playback together; about 0.75 characters of the page each.
    std::size_t playbackBudget = 3'000'000;
    /// In a curve; a screen has about 2,000 columns, and a pair of points stays below one of them.
    std::size_t curvePoints = 4'000;
};

/// Everything the page shows, as the page's scripts read it (page/data.js).
nlohmann::json reportData(const std::vector<SceneResult>& results, const std::vector<LabResult>& labs = {},
                          const ReportSettings& settings = {});

/// JSON that may stand inside a <script> element: without "<", no text in it can end the element or open a comment.
std::string scriptText(const nlohmann::json& data);

}  // namespace plumb::compare
