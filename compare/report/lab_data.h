// SPDX-License-Identifier: MIT
// What does the page know about labs?
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// A list with everything that the page shows of each lab, in the form that its scripts read (page/lab_page.js).
nlohmann::json labsData(const std::vector<LabResult>& labs);

}  // namespace plumb::compare
