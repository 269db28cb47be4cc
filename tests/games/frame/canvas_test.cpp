// SPDX-License-Identifier: MIT
#include <games/frame/canvas.h>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games;

namespace {

/// The distance between two points.
double apart(const Vec2& a, const Vec2& b) {
    return (a - b).norm();
}

int layerOf(const Drawing& drawing, std::size_t place) {
    return drawing.inOrder()[place]->layer;
}

}  // namespace

TEST_CASE("a camera's centre is in the middle of the window, and +y of the world points up", "[games]") {
    for (const PixelSize size : {PixelSize{1280, 720}, PixelSize{1000, 400}, PixelSize{300, 900}}) {
        const Affine view = toPixels(Camera{{3, -2}, 8}, size);
        CHECK(apart(view * Vec2(3, -2), Vec2(size.width / 2.0, size.height / 2.0)) < 1e-9);
        CHECK((view * Vec2(3, -1)).y() < (view * Vec2(3, -2)).y());
        CHECK((view * Vec2(4, -2)).x() > (view * Vec2(3, -2)).x());
    }
}

TEST_CASE("a window of any shape shows the whole safe area, which touches two sides of it", "[games]") {
    Random random(11);
    for (int i = 0; i < test::cases(1000); ++i) {
        const PixelSize size{random.integer(64, 4000), random.integer(36, 3000)};
        const Affine view = screenToPixels(size);
        const Vec2 upper = view * Vec2(0, 0), lower = view * Vec2(screenWidth, screenHeight);
        const double gapX = upper.x() + (size.width - lower.x()), gapY = upper.y() + (size.height - lower.y());
        // Rounding of numbers of a few thousand.
        REQUIRE(upper.minCoeff() > -1e-9);
        REQUIRE(gapX > -1e-9);
        REQUIRE(gapY > -1e-9);
        REQUIRE(std::min(gapX, gapY) < 1e-9);
    }
}

TEST_CASE("at 1280 x 720 a camera of height 9 shows 16 x 9 metres, 80 pixels each", "[games]") {
    Canvas canvas({1280, 720});
    canvas.look({.center = {8, 4.5}, .height = 9});
    CHECK(apart(canvas.visible().lower, {0, 0}) < 1e-12);
    CHECK(apart(canvas.visible().upper, {16, 9}) < 1e-12);
    CHECK_THAT(canvas.unitsPerPixel(), Catch::Matchers::WithinRel(1 / 80.0, 1e-12));
    canvas.screen();
    CHECK_THAT(canvas.unitsPerPixel(), Catch::Matchers::WithinRel(0.5, 1e-12));
    CHECK(canvas.camera().height == 9);
}

TEST_CASE("a camera of height 0 or without a finite centre and a window of 0 pixels are refused", "[games]") {
    Canvas canvas({640, 360});
    CHECK_THROWS_WITH(canvas.look({.height = 0}), test::containsText("Camera.height: 0"));
    CHECK_THROWS_WITH(canvas.look({.center = {NAN, 0}}), test::containsText("Camera.center"));
    CHECK_THROWS_WITH(Canvas({0, 360}), test::containsText("0 x 360"));
}

TEST_CASE("a mark in a higher layer is painted later, marks in one layer are painted in the order they were drawn",
          "[games]") {
    Canvas canvas({640, 360});
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        canvas.layer(random.integer(-2, 2));
        canvas.circle({double(i), 0}, 1, Color{});
    }
    const auto order = canvas.drawing().inOrder();
    REQUIRE(order.size() == 200);
    for (std::size_t i = 1; i < order.size(); ++i) {
        REQUIRE(layerOf(canvas.drawing(), i - 1) <= layerOf(canvas.drawing(), i));
        if (order[i - 1]->layer == order[i]->layer) REQUIRE(order[i - 1] < order[i]);  // both point into one vector
    }
}

TEST_CASE("a place within a place is turned, scaled and shifted by both, and ends with its scope", "[games]") {
    Canvas canvas({640, 360});
    const Vec2 inner(2, 1);
    {
        const auto outer = canvas.place({.position = {100, 50}, .angle = 0.5, .scale = {3, 2}, .opacity = 0.5});
        const auto within = canvas.place({.position = {7, 4}, .angle = -1.25, .scale = {-1, 1}, .opacity = 0.5});
        canvas.circle(inner, 1, Color{});
    }
    canvas.circle(inner, 1, Color{});
    const auto& marks = canvas.drawing().marks;
    const auto turned = [](const Vec2& v, double a) -> Vec2 {
        return {std::cos(a) * v.x() - std::sin(a) * v.y(), std::sin(a) * v.x() + std::cos(a) * v.y()};
    };
    const Vec2 first = Vec2(7, 4) + turned({-2, 1}, -1.25);
    const Vec2 expected = Vec2(100, 50) + turned({3 * first.x(), 2 * first.y()}, 0.5);
    CHECK(apart(marks[0].toPixels * inner, expected) < 1e-9);
    CHECK(marks[0].opacity == 0.25);
    CHECK(apart(marks[1].toPixels * inner, inner) < 1e-12);
    CHECK(marks[1].opacity == 1);
}

TEST_CASE("a clip within a clip is the common part of both, for one beside the other that part is empty", "[games]") {
    Canvas canvas({640, 360});
    {
        const auto outer = canvas.clip({10, 10}, {100, 100});
        {
            const auto inner = canvas.clip({50, 60}, {100, 20});
            canvas.rect({0, 0}, {1, 1}, Color{});
        }
        const auto beside = canvas.clip({200, 0}, {10, 10});
        canvas.rect({0, 0}, {1, 1}, Color{});
    }
    canvas.rect({0, 0}, {1, 1}, Color{});
    const Drawing& drawing = canvas.drawing();
    const auto clipOf = [&](std::size_t i) { return drawing.clips[static_cast<std::size_t>(drawing.marks[i].clip)]; };
    CHECK(apart(clipOf(0).corner, {50, 60}) < 1e-12);
    CHECK(apart(clipOf(0).size, {60, 20}) < 1e-12);
    CHECK(clipOf(1).size.minCoeff() == 0);
    CHECK(drawing.marks[2].clip == -1);
}

TEST_CASE("clear fills a window of any shape from its first pixel to its last", "[games]") {
    for (const PixelSize size : {PixelSize{640, 360}, PixelSize{500, 900}}) {
        Canvas canvas(size);
        canvas.look({.center = {100, 3}, .height = 0.7});
        canvas.clear(Color{});
        const Mark& mark = canvas.drawing().marks[0];
        const auto& rect = std::get<RectMark>(mark.shape);
        const Vec2 a = mark.toPixels * rect.corner, b = mark.toPixels * Vec2(rect.corner + rect.size);
        CHECK(apart(a.cwiseMin(b), {0, 0}) < 1e-9);
        CHECK(apart(a.cwiseMax(b), {double(size.width), double(size.height)}) < 1e-9);
    }
}
