// SPDX-License-Identifier: MIT
// What does a lesson come to, in a terminal?
#pragma once
#include <iosfwd>

#include <compare/command/arguments.h>

namespace plumb::compare {

/// Prints each lesson with the numbers of its run, and writes them as JSON if that is asked for:
/// {"schema": 1, "lessons": [{"name", "title", "slides", "numbers": [{"query", "value", "unit"}],
///                            "worse": [{"title", "engine", "value", "says" or "unsupported"}], "because",
///                            "answers"}]}.
void runLessons(const Arguments& arguments, std::ostream& out);

}  // namespace plumb::compare
