// SPDX-License-Identifier: MIT
#include <games/frame/camera.h>

#include <algorithm>

#include <plumb/math/check.h>

namespace plumb::games {
namespace {

/// Pixels per unit of the screen.
double screenScale(PixelSize size) {
    return std::min(size.width / screenWidth, size.height / screenHeight);
}

}  // namespace

Affine toPixels(const Camera& camera, PixelSize size) {
    requireFinite(camera.center, "Camera.center");
    requirePositive(camera.height, "Camera.height");
    const double scale = screenScale(size) * screenHeight / camera.height;
    const Vec2 middle(size.width / 2.0, size.height / 2.0);
    return {{scale, 0}, {0, -scale}, middle - Vec2(scale * camera.center.x(), -scale * camera.center.y())};
}

Affine screenToPixels(PixelSize size) {
    const double scale = screenScale(size);
    const Vec2 middle(size.width / 2.0, size.height / 2.0);
    return {{scale, 0}, {0, scale}, middle - scale / 2 * Vec2(screenWidth, screenHeight)};
}

Aabb visibleIn(const Affine& toPixels, PixelSize size) {
    const Vec2 scale(toPixels.xAxis.x(), toPixels.yAxis.y());
    const Vec2 first = (-toPixels.origin).cwiseQuotient(scale);
    const Vec2 last = (Vec2(size.width, size.height) - toPixels.origin).cwiseQuotient(scale);
    return {first.cwiseMin(last), first.cwiseMax(last)};
}

}  // namespace plumb::games
