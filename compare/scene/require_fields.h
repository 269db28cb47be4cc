// SPDX-License-Identifier: MIT
// Does each number of a scene's part hold what its list of fields allows?
#pragma once
#include <string>

#include <compare/scene/fields.h>
#include <plumb/math/require_members.h>

namespace plumb::compare {

/// A visitor of fields. What names something, and what is a list or a part with fields of its own, is for whoever knows
/// more of it.
struct FieldCheck {
    const std::string& path;

    template <class T>
    void operator()(const Field& field, const T& value) const {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vec2>) requireAllowed(value, field, {path});
    }
    void orInfinite(const Field& field, double value) const { requireAllowed(value, field, {path}); }
    void oneOf(const auto&, std::span<const char* const>) const {}
};

/// Throws std::invalid_argument, "<path>.<field>: -1 is not positive", for the first that does not.
template <class Part>
void requireFields(const Part& part, const std::string& path) {
    const FieldCheck check{path};
    fields(check, part);
}

}  // namespace plumb::compare
