// SPDX-License-Identifier: MIT
#include <games/maze/art/scene.h>

#include <cmath>
#include <numbers>

#include <games/maze/art/figures.h>
#include <games/maze/art/palette.h>
#include <plumb/math/random.h>

namespace plumb::games::maze {
namespace {

constexpr double ground = 301;  ///< height at which they run; all lengths here are in the screen's units
constexpr double size = 17;     ///< of a tile
constexpr double speed = 150;   ///< [units/s]
constexpr double crossing = 9;  ///< time for one way across the screen [s]
constexpr double crumbsApart = 40;

/// A place of this scale where y points up.
Place standing(const Vec2& at, double scale) {
    return {.position = at, .scale = {scale, -scale}};
}

void drawSky(Canvas& canvas, double seconds) {
    canvas.clear(Paint::linear({0, 0}, night, {0, 260}, Color::hex(0x2c3a78)));
    Random random(4);
    for (int i = 0; i < 90; ++i) {
        const Vec2 at(random.uniform(-120, 760), random.uniform(-60, 250));
        const double twinkle = 0.5 + 0.4 * std::sin(seconds * random.uniform(0.6, 2) + i);
        canvas.circle(at, random.uniform(0.5, 1.4), paper.faded(twinkle));
    }
    const Vec2 moon(549, 186);
    canvas.circle(moon, 90, Paint::radial(moon, cheese.faded(0.35), 90, cheese.faded(0)));
    canvas.circle(moon, 34, Color::hex(0xfff0c2));
    for (const auto& [at, radius] : {std::pair(Vec2(-10, -8), 8.0), {Vec2(12, 6), 6.0}, {Vec2(-4, 15), 4.5}})
        canvas.circle(moon + at, radius, Color::hex(0xecd596));
}

/// A row of clipped trees; the farther row is darker and smaller.
void drawHedge(Canvas& canvas, double top, double step, double shift, const Color& color) {
    const Aabb seen = canvas.visible();
    canvas.rect({seen.lower.x(), top}, {seen.upper.x() - seen.lower.x(), seen.upper.y() - top}, color);
    const int first = static_cast<int>(std::floor((seen.lower.x() - shift) / step)) - 1;
    for (int i = first; shift + i * step < seen.upper.x() + step; ++i) {
        const double rise = step * (0.34 + 0.12 * std::sin(1.7 * i));
        canvas.ellipse({shift + i * step, top + 4}, {0.62 * step, rise}, color);
    }
}

/// The lane between two hedges; the nearer hedge reaches down to the lower edge.
void drawLane(Canvas& canvas, const Aabb& seen) {
    const double width = seen.upper.x() - seen.lower.x();
    const auto [lawn, hedge, rim] = gardenOf(1);
    canvas.rect({seen.lower.x(), ground - 22}, {width, 44}, lawn);
    canvas.rect({seen.lower.x(), ground + 22}, {width, seen.upper.y() - ground - 22}, hedge);
    for (const double side : {-22, 22})
        canvas.line({seen.lower.x(), ground + side}, {seen.upper.x(), ground + side}, rim, 2);
}

void drawCrumbs(Canvas& canvas, double from, double to) {
    for (double x = std::ceil(from / crumbsApart) * crumbsApart; x < to; x += crumbsApart) {
        const Canvas::Scope scope = canvas.place(standing({x, ground}, size));
        drawCrumb(canvas, {0, 0});
    }
}

void drawRunner(Canvas& canvas, double x, bool right, double stride) {
    const Canvas::Scope scope = canvas.place(standing({x, ground}, size));
    drawMouse(canvas, {.angle = right ? 0 : std::numbers::pi, .stride = stride});
}

void drawPack(Canvas& canvas, double first, double apart, const CatPose& pose) {
    for (const Who who : everyone) {
        const double hop = 2.5 * std::fabs(std::sin(5 * pose.stride + static_cast<double>(indexOf(who))));
        const Vec2 at(first + apart * static_cast<double>(indexOf(who)), ground - hop);
        const Canvas::Scope scope = canvas.place(standing(at, size));
        drawCat(canvas, who, pose);
    }
}

}  // namespace

void drawTitleShow(Canvas& canvas, double seconds) {
    canvas.screen();
    drawSky(canvas, seconds);
    drawHedge(canvas, 236, 66, 20, Color::hex(0x0d2138));
    drawHedge(canvas, 262, 84, -30, Color::hex(0x123344));
    const Aabb seen = canvas.visible();
    drawLane(canvas, seen);

    const double time = std::fmod(seconds, 2 * crossing), stride = 4 * seconds;
    const bool there = time < crossing;
    const double way = speed * (there ? time : time - crossing);
    const double mouse = there ? seen.lower.x() - 40 + way : seen.upper.x() + 240 - way;
    if (there) drawCrumbs(canvas, mouse, seen.upper.x());
    if (there) drawPack(canvas, mouse - 80, -44, {Mood::Hunts, Direction::Right, stride});
    if (!there) drawPack(canvas, mouse - 70 - 3 * 44, 44, {Mood::Frightened, Direction::Left, stride});
    drawRunner(canvas, mouse, there, stride);
}

}  // namespace plumb::games::maze
