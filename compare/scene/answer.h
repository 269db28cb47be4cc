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

/// What is followed through a run: a value of a body, or a probe.
struct Reading {
    std::string body{};   ///< its name; "": a probe
    std::string probe{};  ///< its name; "": a body
    BodyValue value{};
};

/// Something that happens in a run. Where no number stands in it, it comes at another time in another scene: an answer
/// that names events stays true when a value of the scene is changed.
struct Happening {
    /// Impact: the velocity of the reading's body jumps within a step.
    enum class Kind { Maximum, Minimum, Returns, IsAbove, IsBelow, Impact, Start } kind = Kind::Start;
    Reading of{};
    int which = 1;                  ///< 1 the first, 2 the second, ...; -1 the last
    std::optional<double> level{};  ///< of Returns, IsAbove and IsBelow; none: the quantity's at the start
};

/// The broad phases by the names that queries have, in the order of broadPhases (plumb/broad/broad_phase.h).
extern const std::vector<std::string> broadPhaseNames;

/// What is asked of the shot that takes a body to another one's place. Low: of the two that hit, the one that flies for
/// a shorter time.
struct AimReading {
    enum class Part { LowAngle, HighAngle, LowTime, HighTime, LeastSpeed } part = Part::LowAngle;
    std::string body{}, target{};  ///< names
};

/// The text between braces. QUANTITY is "y of ball" or "probe pull", HAPPENING one of "first maximum of QUANTITY",
/// "first impact of ball", "QUANTITY first returns to 0", "QUANTITY last is above 2", "QUANTITY second is below start";
/// where it has no quantity, or no body, it is that of the query.
///   QUANTITY, QUANTITY at start, QUANTITY when HAPPENING    at the run's end, its start, at that moment
///   largest QUANTITY, smallest QUANTITY                     of all ticks
///   change of QUANTITY, drop of QUANTITY [when HAPPENING]   since the start
///   first maximum of QUANTITY                               its value there
///   time when HAPPENING, period of QUANTITY, duration       [s]
///   metric joint_error_max
///   gravity, field bodies.ball.mass                         numbers of the scene itself: see set_field.h for the path
///   low angle of ball to target, high time of ball to target, least speed of ball to target
///                                                           of the shot that hits: the kit's ballistics
///   overlap of box and ball                                 how deep they overlap; 0: not at all. Also "at start"
///   tests by grid                                           of pairs of boxes in one step, also by brute, sweep and
///                                                           hierarchy: what each of the kit's broad phases counts
struct AnswerQuery {
    enum class Kind {
        Value,
        Largest,
        Smallest,
        Change,
        Drop,
        Time,
        Period,
        Duration,
        Metric,
        Gravity,
        Field,
        Aim,
        Overlap,
        Tests
    };
    Kind kind = Kind::Value;
    Reading quantity{};
    std::string name{};               ///< of the metric or of the broad phase, or the path of the field
    std::string bodyA{}, bodyB{};     ///< of Overlap: names
    std::optional<Happening> when{};  ///< none: at the end
    AimReading aim{};
};

/// A text, and the query after it, also as it is written; the last part has no query.
struct AnswerPart {
    std::string text{}, asked{};
    std::optional<AnswerQuery> query{};
};

/// Between which a query stands.
struct Marks {
    char open = '{', close = '}';
};

/// The queries of a text. Throws std::invalid_argument, "FIELD: ...", that names the part between the marks if it is
/// not understood, or if the scene does not have its body, probe or metric.
std::vector<AnswerPart> answerParts(const Scene& scene, const std::string& text, const std::string& field,
                                    Marks marks = {});
/// Those of the scene's own answer.
std::vector<AnswerPart> answerParts(const Scene& scene);

/// One such text. Throws in the same way.
AnswerQuery answerQuery(const Scene& scene, const std::string& text, const std::string& field = "answer");

/// "y of ball", "probe pull".
std::string textOf(const Reading& quantity);

}  // namespace plumb::compare
