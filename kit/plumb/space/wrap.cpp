// SPDX-License-Identifier: MIT
#include <plumb/space/wrap.h>

#include <cmath>

namespace plumb {

namespace {

double placedIn(double x, const std::optional<double>& size) {
    if (!size) return x;
    const double rest = std::fmod(x, *size), place = rest < 0 ? rest + *size : rest;
    return place < *size ? place : 0;  // a point just below 0 may be rounded to a whole period
}

double imageIndexIn(double x, const std::optional<double>& size) {
    return size ? std::floor(x / *size) : 0;
}

double shiftIn(double from, double to, const std::optional<double>& size) {
    return size ? std::floor((to - from) / *size + 0.5) * *size : 0;
}

}  // namespace

Vec2 Wrap::placed(const Vec2& point) const {
    return {placedIn(point.x(), width), placedIn(point.y(), height)};
}

Vec2 Wrap::shiftNear(const Vec2& point, const Vec2& other) const {
    return {shiftIn(point.x(), other.x(), width), shiftIn(point.y(), other.y(), height)};
}

Vec2 Wrap::imageIndex(const Vec2& point) const {
    return {imageIndexIn(point.x(), width), imageIndexIn(point.y(), height)};
}

Vec2 Wrap::imageOffset(const Vec2& image) const {
    return {image.x() * width.value_or(0), image.y() * height.value_or(0)};
}

}  // namespace plumb
