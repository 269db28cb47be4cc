// SPDX-License-Identifier: MIT
#include <games/artillery/effects.h>

#include <algorithm>

#include <games/artillery/rules.h>
#include <games/frame/game.h>
#include <plumb/kinematics/linear_drag.h>
#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

using Kind = Happening::Kind;

constexpr std::size_t mostBits = 500;
constexpr double labelSeconds = 1.3;

constexpr Color flash = Color::hex(0xfff3c4), flame = Color::hex(0xff9d3b), smoke = Color::hex(0x4a4358);

}  // namespace

void Effects::begin(const Happening& happening, const Palette& palette) {
    const Vec2& at = happening.at;
    switch (happening.kind) {
        case Kind::Exploded: return explode(at, happening.size, palette);
        case Kind::Fired: {
            const double angle = arcTangent(happening.along.y(), happening.along.x());
            burst(at, {10,
                       2,
                       9,
                       angle - 0.35,
                       angle + 0.35,
                       {.life = 0.7, .size = 0.25, .grow = 0.7, .drag = 4, .fall = 0, .color = paper.faded(0.8)}});
            burst(at, {1, 0, 0.1, 0, 1, {.life = 0.1, .size = 0.8, .grow = 3, .fall = 0, .color = flash}});
            return;
        }
        case Kind::Splashed:
            burst(at, {26, 3, 10, 0.9, 2.25, {.life = 1.1, .size = 0.16, .drag = 0.6, .color = palette.foam}});
            burst(at,
                  {1,
                   0,
                   0.1,
                   0,
                   1,
                   {.life = 0.7, .size = 0.4, .grow = 3, .fall = 0, .color = palette.foam.faded(0.8), .ring = true}});
            return;
        case Kind::Died:
            burst(at, {16,
                       3,
                       8,
                       0,
                       6.28,
                       {.life = 0.8, .size = 0.2, .drag = 3, .fall = 0.2, .color = crewColor(happening.crew)}});
            burst(at, {8,
                       1,
                       3,
                       0,
                       6.28,
                       {.life = 1, .size = 0.5, .grow = 0.5, .drag = 3, .fall = -0.1, .color = paper.faded(0.7)}});
            return;
        case Kind::Thud:
        case Kind::Bounced:
            if (happening.size > 4)
                burst(at, {4,
                           0.5,
                           2.5,
                           0.3,
                           2.8,
                           {.life = 0.5, .size = 0.2, .grow = 0.5, .drag = 4, .fall = 0, .color = paper.faded(0.45)}});
            return;
        case Kind::Walked:
            burst(at - Vec2(0, 0.8),
                  {2,
                   0.3,
                   1,
                   0.5,
                   2.6,
                   {.life = 0.4, .size = 0.12, .grow = 0.4, .drag = 4, .fall = 0, .color = paper.faded(0.4)}});
            return;
        case Kind::Hurt: return label(happening);
        default: return;
    }
}

void Effects::explode(const Vec2& at, double size, const Palette& palette) {
    burst(at, {1, 0, 0.1, 0, 1, {.life = 0.16, .size = size * 0.7, .grow = 5, .fall = 0, .color = flash}});
    burst(at, {1,
               0,
               0.1,
               0,
               1,
               {.life = 0.4, .size = size * 0.4, .grow = size * 2.2, .fall = 0, .color = flash, .ring = true}});
    const int many = static_cast<int>(size * 4);
    burst(at,
          {many, 2, 10, 0, 6.28, {.life = 0.45, .size = 0.55, .grow = -0.6, .drag = 5, .fall = -0.2, .color = flame}});
    burst(at, {many,
               0.5,
               5,
               0,
               6.28,
               {.life = 1.5, .size = 0.5, .grow = 0.8, .drag = 3, .fall = -0.12, .color = smoke.faded(0.6)}});
    burst(at, {many * 2, 5, 15, 0.5, 2.65, {.life = 1.6, .size = 0.2, .drag = 0.4, .color = palette.earthTop}});
}

void Effects::trail(const Vec2& shell) {
    burst(shell, {1,
                  0,
                  0.3,
                  0,
                  6.28,
                  {.life = 0.7, .size = 0.2, .grow = 0.25, .drag = 2, .fall = 0, .color = paper.faded(0.4)}});
}

void Effects::label(const Happening& happening) {
    for (Label& label : labels_)
        if (label.crew == happening.crew && (label.at - happening.at).norm() < 2.5 && label.age < 0.8) {
            label.amount += happening.amount;
            label.age = 0;
            return;
        }
    labels_.push_back({happening.at, happening.amount, happening.crew});
}

void Effects::burst(const Vec2& at, const Burst& burst) {
    for (int i = 0; i < burst.count && bits_.size() < mostBits; ++i) {
        const SinCos way = sinCos(random_.uniform(burst.from, burst.to));
        Bit bit = burst.bit;
        bit.from = {at, random_.uniform(burst.slowest, burst.fastest) * Vec2(way.cos, way.sin)};
        if (burst.count > 1) {
            bit.life *= random_.uniform(0.6, 1);
            bit.size *= random_.uniform(0.6, 1.3);
        }
        bits_.push_back(bit);
    }
}

void Effects::update() {
    for (Bit& bit : bits_) bit.age += tickSeconds;
    for (Label& label : labels_) label.age += tickSeconds;
    std::erase_if(bits_, [](const Bit& bit) { return bit.age >= bit.life; });
    std::erase_if(labels_, [](const Label& label) { return label.age >= labelSeconds; });
}

void Effects::draw(Canvas& canvas, double wind) const {
    const double ahead = (canvas.between() - 1) * tickSeconds;
    for (const Bit& bit : bits_) {
        const double age = std::max(0.0, bit.age + ahead), left = 1 - age / bit.life;
        const Vec2 at = moveWithDrag(bit.from, {bit.drag, {0.5 * wind, 0}, {0, -gravity * bit.fall}}, age).position;
        const double radius = bit.size + bit.grow * age;
        if (left <= 0 || radius <= 0.02) continue;
        const Color color = bit.color.faded(std::min(1.0, 2 * left));
        canvas.circle(at, radius, bit.ring ? stroke(color, 0.3 * left) : Brush(color));
    }
    for (const Label& label : labels_) {
        const double age = std::max(0.0, label.age + ahead);
        const Vec2 at = label.at + Vec2(0, 2.3 + 1.4 * age);
        const double alpha = std::min(1.0, 3 * (labelSeconds - age));
        TextStyle style{.size = 1.7, .color = ink.faded(alpha), .align = Align::Center, .weight = Weight::Heavy};
        const std::string text = "-" + std::to_string(label.amount);
        canvas.text(at + Vec2(0.07, -0.09), text, style);
        style.color = lighter(crewColor(label.crew), 0.45).faded(alpha);
        canvas.text(at, text, style);
    }
}

}  // namespace plumb::games::artillery
