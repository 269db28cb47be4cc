// SPDX-License-Identifier: MIT
#include <games/shell/cairo/kept_painter.h>

#include <games/frame/canvas.h>
#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games;

namespace {

Color anyColor(Random& random) {
    const double red = random.uniform(0, 1), green = random.uniform(0, 1);
    return {red, green, 0.5, random.uniform(0.2, 1)};
}

/// Draws a mark of a random kind at a random place. The same seed gives the same mark.
void drawMark(Canvas& canvas, std::uint64_t seed) {
    Random random(seed);
    const double x = random.uniform(0, 640), y = random.uniform(0, 360);
    const Color color = anyColor(random);
    canvas.layer(random.integer(0, 1));
    switch (random.integer(0, 4)) {
        case 0: canvas.box({x, y}, {40, 30}, color, 6); break;
        case 1: canvas.circle({x, y}, 25, Paint::radial({x, y}, color, 25, anyColor(random))); break;
        case 2: canvas.polyline({{x, y}, {y, x}, {320, 180}}, color, 3); break;
        case 3: canvas.text({x, y}, "mark " + std::to_string(seed), {.size = 20, .color = color}); break;
        default: {
            const auto clip = canvas.clip({x, y}, {random.uniform(1, 60), 60});
            canvas.clear(color);
        }
    }
}

}  // namespace

TEST_CASE("a KeptPainter paints the same pixels as a Painter in 300 drawings, one after another", "[games]") {
    KeptPainter kept;
    const Painter plain;
    Random random(3);
    std::vector<std::uint64_t> marks(100);
    for (std::uint64_t& mark : marks) mark = random.bits() % 1000;
    PixelSize size{320, 180};
    Picture shown(size), expected(size);
    for (int i = 0; i < 300; ++i) {
        // Most often a late mark changes, sometimes any mark, rarely the window; at times nothing changes for a while.
        const int first = random.integer(0, 5) == 0 ? 0 : 95;
        if (i % 100 < 90) marks[static_cast<std::size_t>(random.integer(first, 99))] = random.bits() % 1000;
        if (i % 130 == 129) {
            size = {size.width == 320 ? 200 : 320, 180};
            shown = expected = Picture(size);
        }
        Canvas canvas(size);
        canvas.clear(Color::hex(0x203040));
        for (const std::uint64_t mark : marks) drawMark(canvas, mark);
        kept.paint(canvas.drawing(), shown.view());
        plain.paint(canvas.drawing(), expected.view());
        REQUIRE(shown == expected);
    }
}

TEST_CASE("two, three or four threads paint the same pixels as one thread", "[games]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const PixelSize size{320, 181};
        Canvas canvas(size);
        canvas.clear(Color::hex(0x203040));
        for (std::uint64_t mark = 0; mark < 40; ++mark) drawMark(canvas, 100 * seed + mark);
        Picture expected(size);
        Painter().paint(canvas.drawing(), expected.view());
        for (const int threads : {2, 3, 4}) {
            Picture shown(size);
            Painter({.threads = threads}).paint(canvas.drawing(), shown.view());
            CAPTURE(seed, threads);
            REQUIRE(shown == expected);
        }
    }
}
