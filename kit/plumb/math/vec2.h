// SPDX-License-Identifier: MIT
// Which vector types does the kit use?
//
// A vector is a value of its own, 0 where nothing is given, and so is what comes of arithmetic: `auto d = a - b` holds
// two numbers, never a reference to what is gone. Names are those of Eigen's vectors, and Eigen's vectors and
// expressions of two numbers are taken wherever a vector is: Eigen::Vector2d(v), v + e, rotation * v.
#pragma once
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include <plumb/math/eigen.h>

namespace plumb {

/// A vector of the plane with coordinates of type T.
template <std::floating_point T>
class BasicVec2 {
public:
    using Scalar = T;
    static constexpr int SizeAtCompileTime = 2;

    constexpr BasicVec2() = default;
    constexpr BasicVec2(const BasicVec2&) = default;
    constexpr BasicVec2& operator=(const BasicVec2&) & = default;
    void operator=(const BasicVec2&) && = delete;  // it would be lost: call setPose, setVelocity, ... of the body
    template <std::convertible_to<T> X, std::convertible_to<T> Y>
    constexpr BasicVec2(X x, Y y) : values_{static_cast<T>(x), static_cast<T>(y)} {}
    template <detail::EigenPair<T> E>
    constexpr BasicVec2(const E& pair) {  // NOLINT: as between Eigen's own
        const auto& numbers = pair.eval();
        *this = {numbers.coeff(0), numbers.coeff(1)};
    }

    template <detail::EigenPairObject<T> E>
    constexpr operator E() const {  // NOLINT: as between Eigen's own
        return {values_[0], values_[1]};
    }
    template <std::floating_point Other>
    constexpr BasicVec2<Other> cast() const {
        return {static_cast<Other>(values_[0]), static_cast<Other>(values_[1])};
    }

    static constexpr BasicVec2 Zero() { return {}; }
    static constexpr BasicVec2 Ones() { return {1, 1}; }
    static constexpr BasicVec2 UnitX() { return {1, 0}; }
    static constexpr BasicVec2 UnitY() { return {0, 1}; }
    static constexpr BasicVec2 Unit(std::integral auto axis) { return axis == 0 ? UnitX() : UnitY(); }
    static constexpr BasicVec2 Constant(T value) { return {value, value}; }

    // Only a vector that stays can be written to: `body.position().x() = 3` is refused, for it would be lost.
    constexpr T x() const& { return values_[0]; }
    constexpr T y() const& { return values_[1]; }
    constexpr T& x() & { return values_[0]; }
    constexpr T& y() & { return values_[1]; }
    constexpr T operator[](std::integral auto axis) const& { return values_[axis]; }  ///< axis: 0 or 1
    constexpr T& operator[](std::integral auto axis) & { return values_[axis]; }
    constexpr T operator()(std::integral auto axis) const& { return values_[axis]; }
    constexpr T& operator()(std::integral auto axis) & { return values_[axis]; }
    constexpr const T* data() const& { return values_; }
    constexpr T* data() & { return values_; }
    template <std::size_t axis>
    constexpr T get() const {  ///< for `auto [x, y] = v`
        return values_[axis];
    }
    static constexpr std::ptrdiff_t size() { return 2; }
    constexpr const T* begin() const { return values_; }
    constexpr const T* end() const { return values_ + 2; }

    constexpr BasicVec2& operator+=(const BasicVec2& b) & { return *this = *this + b; }
    constexpr BasicVec2& operator-=(const BasicVec2& b) & { return *this = *this - b; }
    constexpr BasicVec2& operator*=(T factor) & { return *this = *this * factor; }
    constexpr BasicVec2& operator/=(T divisor) & { return *this = *this / divisor; }
    constexpr void setZero() & { *this = {}; }
    constexpr void setConstant(T value) & { *this = Constant(value); }

    friend constexpr BasicVec2 operator+(const BasicVec2& a) { return a; }
    friend constexpr BasicVec2 operator-(const BasicVec2& a) { return {-a.x(), -a.y()}; }
    friend constexpr BasicVec2 operator+(const BasicVec2& a, const BasicVec2& b) {
        return {a.x() + b.x(), a.y() + b.y()};
    }
    friend constexpr BasicVec2 operator-(const BasicVec2& a, const BasicVec2& b) {
        return {a.x() - b.x(), a.y() - b.y()};
    }
    friend constexpr BasicVec2 operator*(const BasicVec2& a, T factor) { return {a.x() * factor, a.y() * factor}; }
    friend constexpr BasicVec2 operator*(T factor, const BasicVec2& a) { return {factor * a.x(), factor * a.y()}; }
    friend constexpr BasicVec2 operator/(const BasicVec2& a, T divisor) { return {a.x() / divisor, a.y() / divisor}; }
    friend constexpr bool operator==(const BasicVec2& a, const BasicVec2& b) {
        return a.x() == b.x() && a.y() == b.y();
    }

    // Two numbers of Eigen's, also a part of a larger vector, change by b.
    template <class E>
    requires detail::EigenPair<std::remove_cvref_t<E>, T>
    friend constexpr void operator+=(E&& pair, const BasicVec2& b) {
        pair.coeffRef(0) += b.x();
        pair.coeffRef(1) += b.y();
    }
    template <class E>
    requires detail::EigenPair<std::remove_cvref_t<E>, T>
    friend constexpr void operator-=(E&& pair, const BasicVec2& b) { pair += -b; }

    // state << position, velocity: as with Eigen's own. Without these the comma would drop what follows it.
    template <detail::FromEigen M>
    friend constexpr auto operator<<(M& matrix, const BasicVec2& v) {
        return matrix << detail::EigenColumn<M>(v);
    }
    template <class L>
    requires detail::EigenList<std::remove_cvref_t<L>>
    friend constexpr auto& operator,(L&& list, const BasicVec2& v) {
        return list.operator,(detail::EigenColumn<std::remove_cvref_t<decltype(list.finished())>>(v));
    }

    template <detail::EigenMatrix2<T> M>
    friend constexpr BasicVec2 operator*(const M& matrix, const BasicVec2& v) {
        const auto& m = matrix.eval();
        return {m.coeff(0, 0) * v.x() + m.coeff(0, 1) * v.y(), m.coeff(1, 0) * v.x() + m.coeff(1, 1) * v.y()};
    }
    template <detail::EigenRotation<T> R>
    friend constexpr BasicVec2 operator*(const R& rotation, const BasicVec2& v) {
        return rotation.toRotationMatrix() * v;
    }
    template <detail::EigenTransform<T> M>
    friend constexpr BasicVec2 operator*(const M& transform, const BasicVec2& v) {
        return transform.linear() * v + transform.translation();
    }

    constexpr T dot(const BasicVec2& b) const { return x() * b.x() + y() * b.y(); }
    constexpr T squaredNorm() const { return dot(*this); }
    T norm() const { return std::sqrt(squaredNorm()); }
    /// The same where squares overflow or vanish.
    T stableNorm() const {
        const T largest = cwiseAbs().maxCoeff();
        return largest > 0 && largest <= std::numeric_limits<T>::max() ? largest * (*this / largest).norm() : largest;
    }
    /// Of length 1; the zero vector stays.
    BasicVec2 normalized() const {
        const T square = squaredNorm();
        return square > 0 ? *this / std::sqrt(square) : *this;
    }
    /// The same where squares overflow or vanish.
    BasicVec2 stableNormalized() const {
        const T largest = cwiseAbs().maxCoeff();
        const T square = (*this / largest).squaredNorm();
        return square > 0 ? *this / (std::sqrt(square) * largest) : *this;
    }
    void normalize() & { *this = normalized(); }
    template <int p>
    requires(p == 1 || p == 2 || p == -1) T lpNorm()
    const {  ///< p = -1, as Eigen::Infinity: the larger |coordinate|
        if constexpr (p == 2) return norm();
        return p == 1 ? cwiseAbs().sum() : cwiseAbs().maxCoeff();
    }

    constexpr T sum() const { return x() + y(); }
    constexpr T prod() const { return x() * y(); }
    constexpr T mean() const { return sum() / 2; }
    constexpr T minCoeff() const { return least(x(), y()); }
    constexpr T maxCoeff() const { return most(x(), y()); }
    BasicVec2 cwiseAbs() const { return {std::fabs(x()), std::fabs(y())}; }
    constexpr BasicVec2 cwiseProduct(const BasicVec2& b) const { return {x() * b.x(), y() * b.y()}; }
    constexpr BasicVec2 cwiseQuotient(const BasicVec2& b) const { return {x() / b.x(), y() / b.y()}; }
    constexpr BasicVec2 cwiseMin(const BasicVec2& b) const { return {least(x(), b.x()), least(y(), b.y())}; }
    constexpr BasicVec2 cwiseMax(const BasicVec2& b) const { return {most(x(), b.x()), most(y(), b.y())}; }
    constexpr BasicVec2 cwiseMin(T bound) const { return cwiseMin(Constant(bound)); }
    constexpr BasicVec2 cwiseMax(T bound) const { return cwiseMax(Constant(bound)); }

    bool allFinite() const { return std::isfinite(x()) && std::isfinite(y()); }
    constexpr bool hasNaN() const { return x() != x() || y() != y(); }
    /// Is no coordinate farther than this from 0?
    bool isZero(T precision = defaultPrecision) const {
        return std::fabs(x()) <= precision && std::fabs(y()) <= precision;
    }
    /// Is the difference at most this part of the shorter one?
    constexpr bool isApprox(const BasicVec2& b, T precision = defaultPrecision) const {
        return (*this - b).squaredNorm() <= precision * precision * least(squaredNorm(), b.squaredNorm());
    }

    // For programs that were written for Eigen's vectors: a value needs neither.
    constexpr BasicVec2 eval() const { return *this; }
    constexpr BasicVec2 transpose() const { return *this; }

    /// "x y".
    template <typename Stream>
    requires requires { typename Stream::char_type; }
    friend Stream& operator<<(Stream& stream, const BasicVec2& v) {
        stream << v.x() << ' ' << v.y();
        return stream;
    }

private:
    static constexpr T defaultPrecision = sizeof(T) == sizeof(float) ? T(1e-5) : T(1e-12);
    static constexpr T least(T a, T b) { return b < a ? b : a; }
    static constexpr T most(T a, T b) { return a < b ? b : a; }

    T values_[2]{};
};

using Vec2 = BasicVec2<double>;  ///< for every public vector, in SI units
using Vec2f = BasicVec2<float>;  ///< in hot loops, for coordinates relative to a body

/// z component of a x b: |a| |b| times the sine of the angle from a to b.
constexpr double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// v rotated by 90 degrees counter-clockwise; times an angular velocity, the velocity of a point at v.
constexpr Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}

// The same in float.
constexpr float cross(const Vec2f& a, const Vec2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}
constexpr Vec2f perp(const Vec2f& v) {
    return {-v.y(), v.x()};
}

}  // namespace plumb

/// Two parts, for `auto [x, y] = v`.
template <class T>
struct std::tuple_size<plumb::BasicVec2<T>> : std::integral_constant<std::size_t, 2> {};
template <std::size_t axis, class T>
struct std::tuple_element<axis, plumb::BasicVec2<T>> {
    using type = T;
};
