// SPDX-License-Identifier: MIT
// How does a person read of labs in a terminal?
#pragma once
#include <iosfwd>
#include <span>
#include <string>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// Name, question, what is varied, and the checks of each lab.
void listLabs(std::span<const Lab> labs, std::ostream& out);

/// The verdict with the name, and a line a check: "ok  order.rk4  0.003, at most 0.1"; of one that fails also why it
/// should hold.
void printLab(const LabResult& result, std::ostream& out, bool colour);

/// How many labs hold, fail, and were not judged.
void printLabSummary(std::span<const LabResult> results, std::ostream& out, bool colour);

/// "at most 0.1 m".
std::string boundText(const LabCheck& check);

}  // namespace plumb::compare
