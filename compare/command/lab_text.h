// SPDX-License-Identifier: MIT
// How are labs shown in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// Prints the name, the question, what is varied, and the checks of each lab.
void listLabs(std::span<const Lab> labs, std::ostream& out);

/// Prints the verdict with the name, and one line for each check: "ok  order.rk4  0.003, at most 0.1". For a check that
/// fails, it also prints why the check should hold.
void printLab(const LabResult& result, std::ostream& out, bool colour);

/// Prints how many labs hold, fail, and were not judged.
void printLabSummary(std::span<const LabResult> results, std::ostream& out, bool colour);

/// "at most 0.1 m".
std::string boundText(const LabCheck& check);

}  // namespace plumb::compare
