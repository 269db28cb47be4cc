// SPDX-License-Identifier: MIT
// Is each number of a part of a scene allowed by the part's list of fields?
#pragma once
#include <string>

#include <compare/scene/fields.h>
#include <plumb/math/require_members.h>

namespace plumb::compare {

/// A visitor of fields. It checks numbers and vectors only. Names, lists and parts with their own fields are checked
/// elsewhere.
struct FieldCheck {
    const std::string& path;

    template <class T>
    void operator()(const Field& field, const T& value) const {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vec2>) requireAllowed(value, field, {path});
    }
    void orInfinite(const Field& field, double value) const { requireAllowed(value, field, {path}); }
    void oneOf(const auto&, std::span<const char* const>) const {}
};

/// Throws std::invalid_argument, "<path>.<field>: -1 is not positive", for the first number that is not allowed.
template <class Part>
void requireFields(const Part& part, const std::string& path) {
    const FieldCheck check{path};
    fields(check, part);
}

}  // namespace plumb::compare
