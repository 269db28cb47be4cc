// SPDX-License-Identifier: MIT
// Which of Eigen's types mix with the kit's vectors? No header of Eigen is included: who uses Eigen includes it.
#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

namespace plumb::detail {

/// An expression or an object of Eigen: a matrix, an array, a sum of two, ...
template <typename E>
concept FromEigen = requires(const E& e) {
    typename E::Scalar;
    E::RowsAtCompileTime;
    e.derived();
    e.eval();
};

/// Two numbers of type T: a vector, a row, or an expression that is one.
template <typename E, typename T>
concept EigenPair = FromEigen<E> && std::same_as<typename E::Scalar, T> && int(E::SizeAtCompileTime) == 2;

/// The same, and an object that can hold its numbers.
template <typename E, typename T>
concept EigenPairObject = EigenPair<E, T> && std::is_default_constructible_v<E>;

/// A matrix of two rows and two columns, or an expression that is one.
template <typename E, typename T>
concept EigenMatrix2 = FromEigen<E> && std::same_as<typename E::Scalar, T> && int(E::RowsAtCompileTime) == 2 &&
                       int(E::ColsAtCompileTime) == 2;

/// Eigen::Rotation2D.
template <typename E, typename T>
concept EigenRotation = std::same_as<typename E::Scalar, T> && int(E::Dim) == 2 && requires(const E& e) {
    { e.toRotationMatrix() } -> EigenMatrix2<T>;
};

/// Eigen::Transform of the plane: Isometry2d, Affine2d.
template <typename E, typename T>
concept EigenTransform = std::same_as<typename E::Scalar, T> && int(E::Dim) == 2 && requires(const E& e) {
    { e.linear() } -> EigenMatrix2<T>;
    { e.translation() } -> EigenPair<T>;
};

/// What Eigen's `state << a, b` makes of its left side.
template <typename L>
concept EigenList = requires(L& list) {
    list.m_xpr.derived();
    list.finished();
};

/// Two numbers below each other, as a type of the library that the matrix is from.
template <typename M>
using EigenColumn = std::remove_cvref_t<decltype(std::declval<M&>().template topLeftCorner<2, 1>().eval())>;

}  // namespace plumb::detail
