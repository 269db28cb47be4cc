// SPDX-License-Identifier: MIT
// Can a lesson be what its file says?
#pragma once
#include <optional>

#include <compare/lesson/lesson.h>

namespace plumb::compare {

/// Throws std::invalid_argument, "predict.number.value: ...", for a name, engine, query, path, unit or range that does
/// not fit the lesson's scene.
void validate(const Lesson& lesson);

/// As which number a control shows what its first path holds; none for one engine's own number, which a scene may leave
/// out. Throws std::invalid_argument if the path does not hold what SceneControl::as reads.
std::optional<double> shownBy(const Scene& scene, const SceneControl& control);

}  // namespace plumb::compare
