// SPDX-License-Identifier: MIT
// What does the page know of labs?
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// A list with all that the page shows of each lab, as its scripts read it (page/lab_page.js).
nlohmann::json labsData(const std::vector<LabResult>& labs);

}  // namespace plumb::compare
