// SPDX-License-Identifier: MIT
#include <plumb/impact/bounce.h>

#include <cmath>
#include <string>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const DroppedBall& ball) {
    requireNotNegative(ball.height, "DroppedBall", ".height");
    requireWithin(ball.restitution, 0, 1, "DroppedBall", ".restitution");
    requirePositive(ball.gravity, "DroppedBall", ".gravity");
}

double dropTime(const DroppedBall& ball) {
    return std::sqrt(2 * ball.height / ball.gravity);
}

/// Of 1 + q + ... + q^(n - 1), and q^n: by doubling, so that a billion terms take sixty products, without cancellation.
struct GeometricSeries {
    double sum = 0, power = 1;
};

GeometricSeries seriesOf(double q, int n) {
    GeometricSeries series;
    for (int bit = 30; bit >= 0; --bit) {
        series = {series.sum * (1 + series.power), series.power * series.power};
        if ((n >> bit) % 2 == 1) series = {series.sum * q + 1, series.power * q};
    }
    return series;
}

}  // namespace

std::optional<BouncesToRest> bouncesToRest(const DroppedBall& ball) {
    requireSound(ball);
    const double e = ball.restitution;
    if (e == 1) return std::nullopt;
    const double sum = (1 + e) / (1 - e);
    return BouncesToRest{dropTime(ball) * sum, ball.height * (1 + e * e) / ((1 - e) * (1 + e))};
}

double bounceTime(const DroppedBall& ball, int n) {
    requireSound(ball);
    if (n < 1) refuse("bounceTime: n", std::to_string(n) + " is less than 1");
    return dropTime(ball) * (2 * seriesOf(ball.restitution, n).sum - 1);
}

double bounceHeight(const DroppedBall& ball, int n) {
    requireSound(ball);
    if (n < 0) refuse("bounceHeight: n", std::to_string(n) + " is negative");
    return ball.height * seriesOf(ball.restitution * ball.restitution, n).power;
}

}  // namespace plumb
