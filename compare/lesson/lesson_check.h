// SPDX-License-Identifier: MIT
// Can a lesson be what its file says?
#pragma once
#include <compare/lesson/lesson.h>

namespace plumb::compare {

/// Throws std::invalid_argument, "predict.number.value: ...", for a name, engine, query, path, unit or range that does
/// not fit the lesson's scene.
void validate(const Lesson& lesson);

}  // namespace plumb::compare
