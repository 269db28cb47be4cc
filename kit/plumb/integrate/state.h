// SPDX-License-Identifier: MIT
// Which types of state can be integrated?
#pragma once
#include <concepts>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <plumb/math/check.h>

namespace plumb {

/// A Vec2, or an Eigen vector (or matrix) of doubles, of fixed or dynamic size; not an expression. Functions for
/// derivatives must return the same type, not an expression either.
template <typename T>
concept EigenState = std::same_as<T, Vec2> ||
    (std::derived_from<T, Eigen::PlainObjectBase<T>>&& std::same_as<typename T::Scalar, double>);

/// Throws std::invalid_argument when the named value does not have the state's size.
template <EigenState State>
void requireSizeOf(const State& state, const State& other, std::string_view name, std::string_view nameOfState) {
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic) {
        if (other.rows() != state.rows() || other.cols() != state.cols())
            refuse(name, "size " + std::to_string(other.size()) + " is not the " + std::string(nameOfState) + "'s, " +
                             std::to_string(state.size()));
    }
}

}  // namespace plumb
