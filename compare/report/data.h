// SPDX-License-Identifier: MIT
// What does the page know about the results?
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/lab/lab.h>

namespace plumb::compare {

struct ReportSettings {
    /// How many numbers all playback may have together; each takes about 0.75 characters of the page.
    std::size_t playbackBudget = 2'700'000;
    /// Points of a curve; a screen has about 2,000 columns, so a pair of points is narrower than a column.
    std::size_t curvePoints = 4'000;
};

/// Everything that the page shows, in the form that its scripts read (packed.js).
nlohmann::json reportData(const std::vector<SceneResult>& results, const std::vector<LabResult>& labs = {},
                          const ReportSettings& settings = {});

/// JSON that may be put inside a <script> element: without "<", no text in it can end the element or open a comment.
std::string scriptText(const nlohmann::json& data);

/// A list with everything that the page shows of each lab, in the form that its scripts read (page/lab_page.js).
nlohmann::json labsData(const std::vector<LabResult>& labs);

}  // namespace plumb::compare
