// SPDX-License-Identifier: MIT
// How are three rows solved together? Plain loops, so that every compiler does the same sums in the same order.
#pragma once
#include <array>

namespace plumb {

using Vec3 = std::array<double, 3>;

/// Row by row.
struct Mat3 {
    std::array<Vec3, 3> row{};

    Vec3& operator[](std::size_t i) { return row[i]; }
    const Vec3& operator[](std::size_t i) const { return row[i]; }
};

inline Vec3 operator*(const Mat3& m, const Vec3& v) {
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

inline Mat3 operator*(const Mat3& a, const Mat3& b) {
    Mat3 result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return result;
}

/// m^T v.
inline Vec3 transposeTimes(const Mat3& m, const Vec3& v) {
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2];
    return result;
}

/// to -= a b^T.
inline void subtractTimesTransposed(Mat3& to, const Mat3& a, const Mat3& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) to[i][j] -= a[i][0] * b[j][0] + a[i][1] * b[j][1] + a[i][2] * b[j][2];
}

inline void subtract(Vec3& from, const Vec3& v) {
    for (std::size_t i = 0; i < 3; ++i) from[i] -= v[i];
}

/// Of a symmetric matrix; zero where it has none.
inline Mat3 symmetricInverse(const Mat3& m) {
    const double a = m[1][1] * m[2][2] - m[1][2] * m[1][2];
    const double b = m[0][2] * m[1][2] - m[0][1] * m[2][2];
    const double c = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    const double determinant = m[0][0] * a + m[0][1] * b + m[0][2] * c;
    if (determinant == 0) return {};
    const double d = 1 / determinant;
    Mat3 result;
    result[0] = {a * d, b * d, c * d};
    result[1] = {b * d, (m[0][0] * m[2][2] - m[0][2] * m[0][2]) * d, (m[0][1] * m[0][2] - m[0][0] * m[1][2]) * d};
    result[2] = {c * d, result[1][2], (m[0][0] * m[1][1] - m[0][1] * m[0][1]) * d};
    return result;
}

}  // namespace plumb
