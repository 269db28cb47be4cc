// SPDX-License-Identifier: MIT
#include <games/shell/cairo/painter.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include <games/frame/canvas.h>

#include "catch.h"
#include "games/texts.h"

using namespace plumb;
using namespace plumb::games;
using test::containsText;

namespace {

const Color white{1, 1, 1, 1};
constexpr std::uint32_t black = 0xff000000, red = 0xffff0000, blue = 0xff0000ff;

const Painter& painter() {
    static const Painter one;
    return one;
}

/// Draws on black, in units of the screen: at 640 x 360 these are pixels.
template <class Draw>
Picture painted(Draw&& draw, PixelSize size = {640, 360}) {
    Canvas canvas(size);
    canvas.clear(Color{});
    draw(canvas);
    Picture picture(size);
    painter().paint(canvas.drawing(), picture.view());
    return picture;
}

/// The sum of the brightness of all pixels, each 0 to 1.
double litIn(const Picture& picture) {
    double sum = 0;
    for (int y = 0; y < picture.size().height; ++y)
        for (int x = 0; x < picture.size().width; ++x) sum += (picture.at(x, y) & 255) / 255.0;
    return sum;
}

Aabb boxOfText(const std::string& text, const TextStyle& style, PixelSize size = {640, 360}) {
    Canvas canvas(size);
    canvas.text({320, 180}, text, style);
    return painter().boxOf(canvas.drawing().marks[0]);
}

double widthOf(const Aabb& box) {
    return box.upper.x() - box.lower.x();
}

}  // namespace

TEST_CASE("a rectangle of 30 x 40 at (10, 20) fills exactly these pixels", "[games]") {
    const Picture picture = painted([](Canvas& c) { c.rect({10, 20}, {30, 40}, Color::hex(0xff0000)); });
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 640; ++x) {
            const bool inside = x >= 10 && x < 40 && y >= 20 && y < 60;
            if (picture.at(x, y) != (inside ? red : black)) FAIL("at " << x << ", " << y);
        }
}

TEST_CASE("the sum of the brightness of antialiased marks is their area", "[games]") {
    // Cairo computes the coverage of a pixel in at most 255 steps, from at least 15 lines: 1/15 pixel along an outline.
    using std::numbers::pi;
    const auto area = [](auto draw) { return litIn(painted(draw)); };
    CHECK(std::abs(area([](Canvas& c) { c.circle({300.3, 180.7}, 100, white); }) - pi * 100 * 100) < 2 * pi * 100 / 15);
    CHECK(std::abs(area([](Canvas& c) { c.pie({300, 180}, 100, 0.3, 1.3, white); }) - 5000) < 300 / 15.0);
    CHECK(std::abs(area([](Canvas& c) { c.polygon({{10, 10}, {110, 10}, {10, 85}}, white); }) - 3750) < 300 / 15.0);
    // A stroke with round ends: a rectangle and a disc.
    CHECK(std::abs(area([](Canvas& c) {
                       c.capsule({100, 100}, {240, 205}, 10, white);
                   }) -
                   (175 * 20 + pi * 100)) < (2 * 175 + 2 * pi * 10) / 15);
    CHECK(std::abs(area([](Canvas& c) {
                       c.rect({10, 10}, {100, 60}, white, 20);
                   }) -
                   (6000 - (4 - pi) * 400)) < 2 * pi * 20 / 15);
    CHECK(std::abs(area([](Canvas& c) {
                       c.circle({300, 180}, 100, stroke(white, 4));
                   }) -
                   2 * pi * 100 * 4) < 4 * pi * 100 / 15);
}

TEST_CASE("the opacities of nested places and the alpha of a colour are multiplied: 0.5 x 0.5 x 0.8 of 255 is 51",
          "[games]") {
    const Picture picture = painted([](Canvas& c) {
        const auto half = c.place({.opacity = 0.5});
        const auto quarter = c.place({.opacity = 0.5});
        c.rect({0, 0}, {10, 10}, white.faded(0.8));
    });
    CHECK(std::abs(int(picture.at(5, 5) & 255) - 51) <= 1);
}

TEST_CASE("a higher layer hides a lower one that was drawn later", "[games]") {
    const Picture picture = painted([](Canvas& c) {
        c.layer(3);
        c.rect({0, 0}, {10, 10}, Color::hex(0xff0000));
        c.layer(1);
        c.rect({0, 0}, {20, 10}, Color::hex(0x0000ff));
    });
    CHECK(picture.at(5, 5) == red);
    CHECK(picture.at(15, 5) == blue);
}

TEST_CASE("nothing is painted outside a clip, after its end everything is painted again", "[games]") {
    const Picture picture = painted([](Canvas& c) {
        {
            const auto clip = c.clip({10, 10}, {20, 20});
            c.circle({10, 10}, 100, Color::hex(0xff0000));
        }
        c.rect({50, 50}, {10, 10}, Color::hex(0x0000ff));
    });
    CHECK(picture.at(9, 15) == black);
    CHECK(picture.at(10, 10) == red);
    CHECK(picture.at(29, 29) == red);
    CHECK(picture.at(30, 29) == black);
    CHECK(picture.at(55, 55) == blue);
}

TEST_CASE("a gradient changes linearly from one colour to the other and stays the same beyond its ends", "[games]") {
    const Picture picture = painted([](Canvas& c) {
        c.rect({0, 0}, {100, 100}, Paint::linear({0, 20}, Color{}, {0, 80}, white));
        c.circle({300, 100}, 80, Paint::radial({300, 100}, white, 40, Color{}));
    });
    const auto gray = [&](int x, int y) { return (picture.at(x, y) & 255) / 255.0; };
    CHECK(gray(50, 5) == 0);
    CHECK_THAT(gray(50, 50), Catch::Matchers::WithinAbs(0.5, 0.02));
    CHECK_THAT(gray(50, 35), Catch::Matchers::WithinAbs(0.26, 0.02));
    CHECK(gray(50, 95) == 1);
    CHECK_THAT(gray(320, 100), Catch::Matchers::WithinAbs(0.5, 0.02));
    CHECK(gray(360, 100) == 0);
}

TEST_CASE("a flat mark and a text too small to be seen paint nothing, and later marks are painted", "[games]") {
    const Picture picture = painted([](Canvas& c) {
        {
            const auto flat = c.place({.scale = {0, 1}});
            c.circle({0, 0}, 50, white);
        }
        c.text({10, 10}, "small", {.size = 0.2});
        c.polygon({{5, 5}}, white);
        c.ellipse({50, 50}, {0, 5}, white);
        c.rect({100, 100}, {10, 10}, Color::hex(0xff0000));
    });
    CHECK(picture.at(105, 105) == red);
    CHECK(picture.at(50, 50) == black);
}

TEST_CASE("a text lies to the right of its position, to the left, or centred on it, with the same width", "[games]") {
    const auto box = [](Align align) { return boxOfText("Plumb 2D", {.size = 30, .align = align}); };
    const Aabb left = box(Align::Left), middle = box(Align::Center), right = box(Align::Right);
    CHECK(widthOf(left) > 100);
    // Rounded to whole pixels.
    CHECK(std::abs(left.lower.x() - 320) <= 0.5);
    CHECK(std::abs(right.upper.x() - 320) <= 0.5);
    CHECK(std::abs(middle.lower.x() + middle.upper.x() - 640) <= 1);
    CHECK_THAT(widthOf(left), Catch::Matchers::WithinAbs(widthOf(middle), 1e-9));
}

TEST_CASE("capital letters lie above their position, below it, or centred on it", "[games]") {
    const auto box = [](Baseline baseline) { return boxOfText("H", {.size = 40, .baseline = baseline}); };
    // Rounded to whole pixels; and a letter's edge may lie a part of a pixel beyond the height in the font.
    CHECK(std::abs(box(Baseline::Base).upper.y() - 180) <= 1);
    CHECK(std::abs(box(Baseline::Top).lower.y() - 180) <= 1.5);
    CHECK(std::abs((box(Baseline::Middle).lower.y() + box(Baseline::Middle).upper.y()) / 2 - 180) <= 1);
}

TEST_CASE("a text that must fit into 100 units is 95 to 100 units wide, a short text is not changed", "[games]") {
    for (const PixelSize size : {PixelSize{640, 360}, PixelSize{1920, 1080}, PixelSize{3840, 2160}}) {
        const double unit = size.width / 640.0;
        const TextStyle style{.size = 40, .align = Align::Center, .weight = Weight::Heavy, .fitWidth = 100};
        const double width = widthOf(boxOfText("A long line of words", style, size));
        CHECK(width <= 100 * unit + 1e-9);
        CHECK(width > 0.95 * 100 * unit);
        TextStyle free = style;
        free.fitWidth = 0;
        CHECK(widthOf(boxOfText("Oh", style, size)) == widthOf(boxOfText("Oh", free, size)));
    }
}

TEST_CASE("numbers with the same number of digits have the same width, in each weight", "[games]") {
    for (const Weight weight : {Weight::Regular, Weight::Bold, Weight::Heavy}) {
        const TextStyle style{.size = 24, .weight = weight};
        CHECK_THAT(widthOf(boxOfText("11111", style)),
                   Catch::Matchers::WithinAbs(widthOf(boxOfText("80406", style)), 1e-9));
        CHECK(widthOf(boxOfText("iiiii", style)) < widthOf(boxOfText("wwwww", style)));
    }
}

TEST_CASE("a text in a world with y up, also in a mirrored place, has the same pixels as on the screen", "[games]") {
    const TextStyle style{.size = 30, .color = white, .align = Align::Center, .baseline = Baseline::Middle};
    TextStyle small = style;
    small.size = 3;
    const Picture screen = painted([&](Canvas& c) { c.text({330, 160}, "Right", style); });
    const Picture world = painted([&](Canvas& c) {
        c.look({.height = 36});  // ten pixels per metre
        c.text({1, 2}, "Right", small);
    });
    const Picture mirrored = painted([&](Canvas& c) {
        c.look({.height = 36});
        const auto place = c.place({.position = {3, 2}, .scale = {-1, 1}});
        c.text({2, 0}, "Right", small);
    });
    CHECK(litIn(screen) > 100);
    CHECK(screen == world);
    CHECK(screen == mirrored);
}

TEST_CASE("a text in a place that is turned by a quarter turn runs down the screen", "[games]") {
    Canvas canvas({640, 360});
    const auto place = canvas.place({.position = {320, 100}, .angle = std::numbers::pi / 2});
    canvas.text({0, 0}, "Downward", {.size = 20});
    const Aabb box = painter().boxOf(canvas.drawing().marks[0]);
    CHECK(box.upper.y() - box.lower.y() > 3 * (box.upper.x() - box.lower.x()));
    CHECK_THAT(box.lower.y(), Catch::Matchers::WithinAbs(100, 1e-6));
}

TEST_CASE("the checks find one text that reaches out of the window, and one that overlaps another", "[games]") {
    Canvas canvas({640, 360});
    canvas.text({600, 100}, "too far to the right", {});
    canvas.text({100, 100}, "here", {});
    canvas.text({110, 102}, "there", {});
    CHECK(test::textsCutOff(canvas.drawing(), painter()).size() == 1);
    CHECK(test::textsOverlapping(canvas.drawing(), painter(), 0).size() == 1);
}

TEST_CASE("a picture is written as a PNG of its size, an error names a folder that does not exist", "[games]") {
    const std::string file = (std::filesystem::temp_directory_path() / "a.png").string();
    Picture picture = painted([](Canvas& c) { c.circle({100, 100}, 50, white); }, {320, 180});
    writePng(picture.view(), file);
    std::ifstream in(file, std::ios::binary);
    std::string head(24, '\0');
    in.read(head.data(), 24);
    CHECK(head.substr(1, 3) == "PNG");
    // Width and height, four bytes each, the highest first. Source: PNG specification, 11.2.2 IHDR.
    CHECK(head.substr(16) == std::string("\0\0\x01\x40\0\0\0\xb4", 8));
    CHECK_THROWS_WITH(writePng(picture.view(), "/no/such/folder/a.png"), containsText("/no/such/folder/a.png"));
}

TEST_CASE("a drawing of another size than the picture is refused", "[games]") {
    Picture picture({10, 10});
    CHECK_THROWS_WITH(painter().paint(Canvas({20, 10}).drawing(), picture.view()), containsText("another size"));
}
