// SPDX-License-Identifier: MIT
// Which states can be integrated?
#pragma once
#include <concepts>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <plumb/math/check.h>

namespace plumb {

/// A vector (or matrix) of doubles of Eigen's, of fixed or dynamic size; no expression. What gives derivatives is
/// to return the like, not an expression either.
template <typename T>
concept EigenState = std::derived_from<T, Eigen::PlainObjectBase<T>> && std::same_as<typename T::Scalar, double>;

/// Throws std::invalid_argument when what is named is not of the state's size.
template <EigenState State>
void requireSizeOf(const State& state, const State& other, std::string_view name, std::string_view nameOfState) {
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic) {
        if (other.rows() != state.rows() || other.cols() != state.cols())
            refuse(name, "size " + std::to_string(other.size()) + " is not the " + std::string(nameOfState) + "'s, " +
                             std::to_string(state.size()));
    }
}

}  // namespace plumb
