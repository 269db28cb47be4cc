// SPDX-License-Identifier: MIT
#include <plumb/math/vec2.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

#include <Eigen/Geometry>

#include <plumb/math/random.h>
#include <plumb/math/transform.h>
#include <plumb/plumb.h>

#include "catch.h"

using namespace plumb;
using Pair = Eigen::Vector2d;

namespace {

template <typename T>
constexpr bool isValue = std::is_same_v<T, Vec2>;

template <typename T>
T any();  // for decltype only

#define IS_VALUE(expression) static_assert(isValue<decltype(expression)>)

// Of two vectors, and of a vector and a number of any type.
IS_VALUE(any<Vec2>() + any<Vec2>());
IS_VALUE(any<Vec2>() - any<Vec2>());
IS_VALUE(-any<Vec2>());
IS_VALUE(+any<Vec2>());
IS_VALUE(any<Vec2>() * 2.0);
IS_VALUE(2.0 * any<Vec2>());
IS_VALUE(any<Vec2>() * 2);
IS_VALUE(2 * any<Vec2>());
IS_VALUE(any<float>() * any<Vec2>());
IS_VALUE(any<Vec2>() / 2);
IS_VALUE(any<Vec2>().normalized());
IS_VALUE(any<Vec2>().stableNormalized());
IS_VALUE(any<Vec2>().cwiseAbs());
IS_VALUE(any<Vec2>().cwiseMin(any<Vec2>()));
IS_VALUE(any<Vec2>().cwiseMax(0.5));
IS_VALUE(any<Vec2>().cwiseProduct(any<Vec2>()));
IS_VALUE(any<Vec2>().cwiseQuotient(any<Vec2>()));
IS_VALUE(any<Vec2f>().cast<double>());
IS_VALUE(perp(any<Vec2>() - any<Vec2>()));

// Of a vector and what is Eigen's.
IS_VALUE(any<Vec2>() + any<Pair>());
IS_VALUE(any<Pair>() + any<Vec2>());
IS_VALUE(any<Vec2>() - (any<Pair>() + 2 * any<Pair>()));
IS_VALUE((any<Pair>() - any<Pair>()) - any<Vec2>());
IS_VALUE(any<Vec2>().cwiseProduct(any<Pair>() + any<Pair>()));
IS_VALUE(any<Eigen::Matrix2d>() * any<Vec2>());
IS_VALUE((any<Eigen::Matrix2d>() * any<Eigen::Matrix2d>()) * any<Vec2>());
IS_VALUE(any<Eigen::Rotation2Dd>() * any<Vec2>());
IS_VALUE(any<Eigen::Isometry2d>() * any<Vec2>());
IS_VALUE(any<Eigen::Affine2d>() * any<Vec2>());

// Of rotations and transforms.
IS_VALUE(any<Rot>() * any<Vec2>());
IS_VALUE(any<Rot>() * (any<Pair>() - any<Pair>()));
IS_VALUE(any<Transform>() * any<Vec2>());
IS_VALUE(any<Transform>() * (any<Vec2>() + any<Pair>()));
static_assert(std::is_same_v<decltype(any<Rot>() * any<Rot>()), Rot>);
static_assert(std::is_same_v<decltype(any<Rot>().inverse()), Rot>);
static_assert(std::is_same_v<decltype(any<Transform>() * any<Transform>()), Transform>);
static_assert(std::is_same_v<decltype(any<Transform>().inverse()), Transform>);

static_assert(std::is_trivially_copyable_v<Vec2> && sizeof(Vec2) == 2 * sizeof(double));
// What is written to a value that nobody keeps would be lost.
static_assert(std::is_assignable_v<Vec2&, Vec2> && !std::is_assignable_v<Vec2, Vec2>);
static_assert(std::is_same_v<decltype(any<Vec2>().x()), double>);

static_assert(Vec2() == Vec2(0, 0) && Vec2(1, 2) + Vec2(2, 2) == Vec2(3, 4));

Vec2 someVector(Random& random) {
    return {random.uniform(-1, 1) * std::exp2(random.integer(-20, 20)), random.uniform(-1, 1)};
}

}  // namespace

TEST_CASE("the difference of two positions under auto is a vector, and stays what it was", "[math]") {
    World world;
    const BodyId a = world.add({.position = {3, 4}, .shapes = {circle(0.5)}});
    const BodyId b = world.add({.shapes = {circle(0.5)}});
    const auto apart = world.body(a).position() - world.body(b).position();
    const auto sum = world.body(a).velocity() * 2 + world.body(b).velocity();
    world.step(0.1);
    CHECK(apart == Vec2(3, 4));
    CHECK(sum == Vec2(0, 0));
    IS_VALUE(apart + sum);
}

// Eigen's own vectors work out the same: bit by bit.
TEST_CASE("arithmetic of vectors gives the numbers of Eigen's", "[math]") {
    Random random(64);
    for (int round = 0; round < 10'000; ++round) {
        const Vec2 a = someVector(random), b = someVector(random);
        const double s = random.uniform(-3, 3);
        const Pair p = a, q = b;
        CHECK(a + b == Vec2(p + q));
        CHECK(a - 2 * b == Vec2(p - 2 * q));
        CHECK(s * a / (s + 4) == Vec2(s * p / (s + 4)));
        CHECK(a.dot(b) == p.dot(q));
        CHECK(a.norm() == p.norm());
        CHECK(a.normalized() == Vec2(p.normalized()));
        CHECK(a.stableNormalized() == Vec2(p.stableNormalized()));
        CHECK(std::fabs(a.stableNorm() - p.stableNorm()) <= 1e-15 * p.norm());
        CHECK(a.lpNorm<1>() == p.lpNorm<1>());
        CHECK(a.lpNorm<Eigen::Infinity>() == p.lpNorm<Eigen::Infinity>());
        CHECK(a.cwiseMin(b) == Vec2(p.cwiseMin(q)));
        CHECK(a.cwiseMax(s) == Vec2(p.cwiseMax(s)));
        CHECK(a.cwiseQuotient(b) == Vec2(p.cwiseQuotient(q)));
        CHECK(Vec2(p.sum(), p.prod()) == Vec2(a.sum(), a.prod()));
        CHECK(Vec2(p.minCoeff(), p.maxCoeff()) == Vec2(a.minCoeff(), a.maxCoeff()));
        CHECK(a.isApprox(a + 1e-9 * b, 1e-6) == p.isApprox(p + 1e-9 * q, 1e-6));
        CHECK(a.isZero(0.5) == p.isZero(0.5));
    }
}

TEST_CASE("a vector and Eigen's types become each other", "[math]") {
    const Vec2 a(3, 4);
    Pair p = a;
    p += a;
    p -= Vec2(1, 1);
    CHECK(p == Pair(5, 7));
    CHECK(p == Vec2(5, 7));
    Eigen::VectorXd state = Eigen::VectorXd::Zero(4);
    state.segment<2>(2) += a;
    state.head<2>() -= a;
    state.head<2>() = Pair(a) + Pair(state.head<2>());
    CHECK(state == Eigen::Vector4d(0, 0, 3, 4));
    CHECK(Vec2(state.tail<2>()) == a);
    Eigen::Matrix<double, 5, 1> listed;
    listed << 7, a, 2 * a;
    CHECK(listed.transpose() == Eigen::Matrix<double, 1, 5>(7, 3, 4, 6, 8));
    listed << a, state.head<2>(), a.norm();
    CHECK(listed.transpose() == Eigen::Matrix<double, 1, 5>(3, 4, 0, 0, 5));
    Eigen::Matrix2d columns;
    columns << a, -a;
    CHECK(columns.col(1) == Pair(-3, -4));
    const Eigen::Matrix2d quarter{{0, -1}, {1, 0}};
    CHECK(quarter * a == perp(a));
    CHECK(Vec2(quarter * p) == perp(Vec2(p)));
    CHECK((Eigen::Rotation2Dd(0.3) * a).isApprox(Rot::fromAngle(0.3) * a));
    CHECK(Eigen::Isometry2d(Eigen::Translation2d(1, 2)) * a == Vec2(4, 6));
}

TEST_CASE("the length of a tiny and of a huge vector", "[math]") {
    CHECK_THAT(Vec2(3e-200, 4e-200).stableNorm(), Catch::Matchers::WithinRel(5e-200, 1e-15));
    CHECK_THAT(Vec2(3e200, 4e200).stableNorm(), Catch::Matchers::WithinRel(5e200, 1e-15));
    CHECK(Vec2(3e200, 4e200).stableNormalized().isApprox({0.6, 0.8}));
    CHECK(Vec2(0, 0).stableNorm() == 0);
    CHECK(Vec2(0, 0).normalized() == Vec2(0, 0));
    CHECK(Vec2(std::numeric_limits<double>::infinity(), 1).stableNorm() == std::numeric_limits<double>::infinity());
    CHECK(std::isnan(Vec2(1, std::nan("")).norm()));
    CHECK(Vec2(1, std::nan("")).hasNaN());
    CHECK_FALSE(Vec2(1, std::nan("")).allFinite());
}

TEST_CASE("a vector that nobody set is 0, and prints as two numbers", "[math]") {
    const std::vector<Vec2> made(3);
    CHECK(made.back() == Vec2(0, 0));
    std::ostringstream text;
    text << Vec2(1, 2.5) << ", " << Vec2(3, 4).transpose();
    CHECK(text.str() == "1 2.5, 3 4");
    const auto [x, y] = Vec2(8, 9);
    CHECK(x + y == 17);
    Vec2 changed(1, 2);
    changed.x() = 5;
    changed[1] *= 2;
    changed *= 2;
    CHECK(changed == Vec2(10, 8));
}
