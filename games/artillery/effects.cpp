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
constexpr Color trailSmoke = Color::hex(0x8b8299).faded(0.55);  // visible on dark and light skies

}  // namespace

void Effects::begin(const Happening& happening, const Palette& palette) {
    const Vec2& at = happening.at;
    switch (happening.kind) {
        case Kind::Exploded: return explode(at, happening.size, palette);
        case Kind::Fired: return fire(at, happening.along);
        case Kind::Splashed: return splash(at, palette.foam);
        case Kind::Died: return die(at, happening.crew);
        case Kind::Thud:
        case Kind::Bounced:
            if (happening.size > 4) dust(at, 4, 0.2);
            return;
        case Kind::Walked: return dust(at - Vec2(0, 0.8), 2, 0.12);
        case Kind::Hurt: return label(happening);
        default: return;
    }
}

void Effects::explode(const Vec2& at, double size, const Palette& palette) {
    spot(at, {.life = 0.16, .size = size * 0.7, .grow = 5, .color = flash});
    spot(at, {.life = 0.4, .size = size * 0.4, .grow = size * 2.2, .color = flash, .ring = true});
    const int many = static_cast<int>(size * 4);
    Bit bit{.life = 0.45, .size = 0.55, .grow = -0.6, .drag = 5, .fall = -0.2, .color = flame};
    burst(at, {.count = many, .speed = {2, 10}, .bit = bit});
    bit = {.life = 1.5, .size = 0.5, .grow = 0.8, .drag = 3, .fall = -0.12, .color = smoke.faded(0.6)};
    burst(at, {.count = many, .speed = {0.5, 5}, .bit = bit});
    bit = {.life = 1.6, .size = 0.2, .drag = 0.4, .color = palette.earthTop};
    burst(at, {.count = 2 * many, .speed = {5, 15}, .angle = {0.5, 2.65}, .bit = bit});
    // Embers rise out of the crater when the smoke is gone.
    bit = {.life = 3, .size = 0.1, .grow = -0.03, .drag = 1.5, .fall = -0.06, .color = flame};
    burst(at, {.count = many / 2, .speed = {0.2, 3}, .angle = {0.3, 2.85}, .bit = bit});
}

void Effects::fire(const Vec2& at, const Vec2& along) {
    const double angle = arcTangent(along.y(), along.x());
    const Bit puff{.life = 0.7, .size = 0.25, .grow = 0.7, .drag = 4, .fall = 0, .color = paper.faded(0.8)};
    burst(at, {.count = 10, .speed = {2, 9}, .angle = {angle - 0.35, angle + 0.35}, .bit = puff});
    spot(at, {.life = 0.1, .size = 0.8, .grow = 3, .color = flash});
}

void Effects::splash(const Vec2& at, const Color& foam) {
    const Bit drop{.life = 1.1, .size = 0.16, .drag = 0.6, .color = foam};
    burst(at, {.count = 26, .speed = {3, 10}, .angle = {0.9, 2.25}, .bit = drop});
    spot(at, {.life = 0.7, .size = 0.4, .grow = 3, .color = foam.faded(0.8), .ring = true});
}

void Effects::die(const Vec2& at, int crew) {
    Bit bit{.life = 0.8, .size = 0.2, .drag = 3, .fall = 0.2, .color = crewColor(crew)};
    burst(at, {.count = 16, .speed = {3, 8}, .bit = bit});
    bit = {.life = 1, .size = 0.5, .grow = 0.5, .drag = 3, .fall = -0.1, .color = paper.faded(0.7)};
    burst(at, {.count = 8, .speed = {1, 3}, .bit = bit});
}

void Effects::dust(const Vec2& at, int count, double size) {
    const Bit puff{.life = 0.5, .size = size, .grow = 0.5, .drag = 4, .fall = 0, .color = paper.faded(0.45)};
    burst(at, {.count = count, .speed = {0.5, 2.5}, .angle = {0.3, 2.8}, .bit = puff});
}

void Effects::trail(const Vec2& shell) {
    const Bit puff{.life = 0.9, .size = 0.2, .grow = 0.3, .drag = 2, .fall = 0, .color = trailSmoke};
    burst(shell, {.speed = {0, 0.3}, .bit = puff});
}

void Effects::celebrate(const Vec2& at, const Color& color) {
    spot(at, {.life = 0.12, .size = 0.5, .grow = 6, .color = flash});
    for (const Color& light : {color, gold}) {
        const Bit spark{.life = 1.3, .size = 0.17, .grow = -0.08, .drag = 1.8, .fall = 0.25, .color = light};
        burst(at, {.count = 16, .speed = {5, 9}, .bit = spark});
    }
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
        const SinCos way = sinCos(random_.uniform(burst.angle.least, burst.angle.most));
        Bit bit = burst.bit;
        bit.from = {at, random_.uniform(burst.speed.least, burst.speed.most) * Vec2(way.cos, way.sin)};
        bit.life *= random_.uniform(0.6, 1);
        bit.size *= random_.uniform(0.6, 1.3);
        bits_.push_back(bit);
    }
}

void Effects::spot(const Vec2& at, const Bit& bit) {
    bits_.push_back(bit);
    bits_.back().from = {at, {0, 0}};
    bits_.back().drag = bits_.back().fall = 0;
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
}

void Effects::drawLabels(Canvas& canvas) const {
    const double ahead = (canvas.between() - 1) * tickSeconds;
    for (const Label& label : labels_) drawLabel(canvas, label, std::max(0.0, label.age + ahead));
}

/// The damage done, with an outline so that it is readable on any sky. It pops up and floats away. For gunners outside
/// the picture it appears at the picture's edge.
void Effects::drawLabel(Canvas& canvas, const Label& label, double age) const {
    // At its end it shrinks and does not fade: a half transparent text shows its dark edge through.
    const double shrunk = std::clamp(3 * (labelSeconds - age), 0.0, 1.0);
    const double jump = 1 + 0.5 * std::max(0.0, 1 - 6 * age);
    const double size = 1.7 * jump * shrunk;
    const Aabb seen = inflate(canvas.visible(), -size);
    const Vec2 at = (label.at + Vec2(0, 2.3 + 1.4 * age)).cwiseMax(seen.lower).cwiseMin(seen.upper);
    TextStyle style{.size = size, .color = ink, .align = Align::Center, .weight = Weight::Heavy};
    const std::string text = "-" + std::to_string(label.amount);
    for (const Vec2& edge : {Vec2(0.1, -0.14), Vec2(-0.1, -0.1), Vec2(0.1, 0.1), Vec2(-0.1, 0.1)})
        canvas.text(at + shrunk * edge, text, style);
    style.color = lighter(crewColor(label.crew), 0.6);
    canvas.text(at, text, style);
}

}  // namespace plumb::games::artillery
