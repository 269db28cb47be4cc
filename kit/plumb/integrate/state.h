// SPDX-License-Identifier: MIT
// Which states can be integrated?
#pragma once
#include <concepts>
#include <string>

#include <Eigen/Core>

#include <plumb/math/check.h>

namespace plumb {

/// A vector (or matrix) of doubles of Eigen's, of fixed or dynamic size; no expression. What gives derivatives is to
/// return the like, not an expression either.
template <typename T>
concept EigenState = std::derived_from<T, Eigen::PlainObjectBase<T>> && std::same_as<typename T::Scalar, double>;

/// Throws std::invalid_argument when a derivative is not of the state's size.
template <EigenState State>
void requireSizeOf(const State& state, const State& derivative) {
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic) {
        if (derivative.rows() != state.rows() || derivative.cols() != state.cols())
            refuse("derivative", "size " + std::to_string(derivative.size()) + " is not that of the state, " +
                                     std::to_string(state.size()));
    }
}

}  // namespace plumb
