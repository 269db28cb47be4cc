// SPDX-License-Identifier: MIT
// How can the arguments of a call be wrong, and what is then said?
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kit/dynamics/bad_input.h"
#include "numbers.h"

namespace plumb::test {

/// A number that is wrong, and why.
struct BadNumber {
    double value;
    std::string text, complaint;
};
using BadNumbers = std::vector<BadNumber>;

inline BadNumbers joined(BadNumbers a, const BadNumbers& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
inline const BadNumbers notFinite{
    {nan, "nan", "is not finite"}, {infinity, "inf", "is not finite"}, {-infinity, "-inf", "is not finite"}};
inline const BadNumbers negative = joined(notFinite, {{-1, "-1", "is negative"}, {-1e-300, "-1e-300", "is negative"}});
inline const BadNumbers notPositive = joined(notFinite, {{-1, "-1", "is not positive"}, {0, "0", "is not positive"}});

/// Of a function, and how it is named, "World.step: dt" if field is empty.
struct Argument {
    std::string function, name, field = {};
};

/// A call with a wrong argument, and what is then said: "<field>: ... <complaint>".
struct BadCall {
    Argument argument;
    std::function<void(Bench&)> call;
    std::string field, complaint;
};

/// A table of bad calls, made an argument at a time.
class BadCalls {
public:
    std::vector<BadCall> all;

    void one(const Argument& of, const std::string& complaint, std::function<void(Bench&)> call);
    void numbers(const Argument& of, const BadNumbers& bads, const std::function<void(Bench&, double)>& call);
    /// Each coordinate.
    void vectors(const Argument& of, const std::function<void(Bench&, const Vec2&)>& call);
    void vectors(const Argument& of, const BadNumbers& bads, const std::function<void(Bench&, const Vec2&)>& call);
    /// All that can be wrong with a pose, but for what makes no direction.
    void poses(const std::string& function, const std::function<void(Bench&, const Transform&)>& call);
    void shapes(const std::string& function, const std::function<void(Bench&, const Shape&)>& call);
    void bodyIds(const Argument& of, const std::function<void(Bench&, BodyId)>& call);
    /// Where none may be named.
    void otherBodyIds(const Argument& of, const std::function<void(Bench&, BodyId)>& call);
    void shapeIds(const Argument& of, const std::function<void(Bench&, ShapeId)>& call);
    void jointIds(const std::string& function, const std::function<void(Bench&, JointId)>& call);
};

/// Those of impact(), of springs, outlines and masses, which know no world.
void addCallsWithoutWorld(BadCalls& calls);

}  // namespace plumb::test
