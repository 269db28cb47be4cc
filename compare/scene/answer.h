// SPDX-License-Identifier: MIT
// What does a scene's answer read from a run?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The value of a body that is read.
enum class BodyValue { X, Y, Angle, Vx, Vy, Speed, Spin };

/// Which value of a run is taken?
enum class Pick { Last, At, Largest, Smallest, Change, Drop, TimeOfLargest, TimeOfSmallest };

/// The text between braces: "largest y of ball", "x of ball at 1.5", "change of angle of rod", "drop of y of ball",
/// "time of largest y of ball", "probe pull", "largest probe pull", "metric joint_error_max".
struct AnswerQuery {
    enum class Kind { Body, Probe, Metric } kind = Kind::Body;
    std::string name{};  ///< of the body, the probe or the metric
    BodyValue value{};
    Pick pick{};
    double time = 0;  ///< with Pick::At [s]
};

/// A text, and the query after it; the last part has no query.
struct AnswerPart {
    std::string text{};
    std::optional<AnswerQuery> query{};
};

/// Throws std::invalid_argument that names the part between braces if it is not understood, or if the scene does not
/// have its body, probe or metric.
std::vector<AnswerPart> answerParts(const Scene& scene);

}  // namespace plumb::compare
