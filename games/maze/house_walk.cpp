// SPDX-License-Identifier: MIT
#include <games/maze/house_walk.h>

namespace plumb::games::maze {
namespace {

constexpr int bobPixels = 4;  ///< up and down from home

constexpr int towards(int from, int to) {
    return from < to ? 1 : from > to ? -1 : 0;
}

Pixel pixelOf(const GridPlace& place) {
    const Vec2 pixels = positionOf(place) * pixelsPerTile;
    return {static_cast<int>(pixels.x()), static_cast<int>(pixels.y())};
}

}  // namespace

Pixel homeOf(Who who) {
    return pixelOf(specialPlaces().starts[indexOf(who == Who::Chaser ? Who::Ambusher : who)]);
}

Pixel doorstep() {
    return pixelOf(specialPlaces().starts[indexOf(Who::Chaser)]);
}

void HouseWalk::bob(SpeedPattern speed) {
    for (int pixels = speed.pixels(frame_++); pixels > 0; --pixels) {
        const int off = at_.y - homeOf(who_).y;
        if (off >= bobPixels) looks_ = Direction::Down;
        if (off <= -bobPixels) looks_ = Direction::Up;
        at_.y += looks_ == Direction::Up ? 1 : -1;
    }
}

bool HouseWalk::leave(SpeedPattern speed) {
    return walkTo(doorstep(), true, speed);
}

bool HouseWalk::enter(SpeedPattern speed) {
    return walkTo(homeOf(who_), false, speed);
}

bool HouseWalk::walkTo(const Pixel& place, bool firstAcross, SpeedPattern speed) {
    for (int pixels = speed.pixels(frame_++); pixels > 0; --pixels) stepTo(place, firstAcross);
    return at_ == place;
}

void HouseWalk::stepTo(const Pixel& place, bool firstAcross) {
    const int x = towards(at_.x, place.x), y = towards(at_.y, place.y);
    const bool across = x != 0 && (firstAcross || y == 0);
    if (across) {
        at_.x += x;
        looks_ = x > 0 ? Direction::Right : Direction::Left;
    } else if (y != 0) {
        at_.y += y;
        looks_ = y > 0 ? Direction::Up : Direction::Down;
    }
}

}  // namespace plumb::games::maze
