// SPDX-License-Identifier: MIT
#include <games/runner/effects.h>

#include <cmath>
#include <numbers>

#include <games/runner/palette.h>

namespace plumb::games::runner {
namespace {

constexpr int wordsLife = 50, ringLife = 22;  ///< [ticks]

double shareOf(int age, int life) {
    return static_cast<double>(age) / life;
}

}  // namespace

void Effects::clear() {
    bits_.clear();
    words_.clear();
    rings_.clear();
}

void Effects::say(const Vec2& at, std::string words, const Color& color) {
    words_.push_back({at, std::move(words), color});
}

void Effects::trail(const Vec2& at, const Vec2& velocity, const Color& color) {
    const double aside = random_.uniform(-0.4, 0.4), up = random_.uniform(0.6, 1.6);
    bits_.push_back({.at = at,
                     .velocity = velocity + Vec2(aside, up),
                     .color = color,
                     .size = random_.uniform(0.03, 0.07),
                     .gravity = -1,
                     .drag = 1,
                     .life = random_.integer(14, 30)});
}

void Effects::burst(const Vec2& at, int count, double slow, double fast, double lift, Bit like) {
    for (int i = 0; i < count; ++i) {
        const double angle = random_.uniform(0, 2 * std::numbers::pi), speed = random_.uniform(slow, fast);
        Bit bit = like;
        bit.at = at;
        bit.velocity = Vec2(std::cos(angle) * speed, std::sin(angle) * speed + lift);
        bit.size *= random_.uniform(0.6, 1.4);
        bit.life = static_cast<int>(bit.life * random_.uniform(0.7, 1.3));
        bit.angle = angle;
        bit.spin = random_.uniform(-0.2, 0.2);
        bits_.push_back(bit);
    }
}

void Effects::dust(const Vec2& at, int count, double strength, const Color& color) {
    for (int i = 0; i < count; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        bits_.push_back({.at = at + Vec2(side * random_.uniform(0.05, 0.3), 0.05),
                         .velocity = {side * random_.uniform(0.5, 1) * strength, random_.uniform(0.2, 1)},
                         .color = color.faded(0.75),
                         .size = random_.uniform(0.07, 0.13),
                         .drag = 4,
                         .growth = 0.25,
                         .life = random_.integer(16, 28)});
    }
}

void Effects::hear(const Event& event, const Palette& palette) {
    const Color dustColor = palette.dust, fire = Color::hex(0xffb03a);
    switch (event.kind) {
        case EventKind::Jumped: return dust(event.at - Vec2(0, 0.45), 6, 2, dustColor);
        case EventKind::Landed:
            if (event.strength > 6) dust(event.at, 4 + static_cast<int>(event.strength / 2), 3, dustColor);
            return;
        case EventKind::Skidded: return dust(event.at, 3, 2.4, dustColor);
        case EventKind::Stomped:
        case EventKind::Squashed:
            rings_.push_back({event.at, palette.metal, 1.1});
            return burst(event.at, 10, 2, 5, 2, {.color = palette.metal, .size = 0.09, .gravity = 16, .life = 30});
        case EventKind::Sprung: return dust(event.at, 10, 4, dustColor);
        case EventKind::Coin:
            return burst(event.at, 7, 1, 3, 1, {.color = palette.coin, .size = 0.06, .drag = 2, .life = 22});
        case EventKind::Sun:
            rings_.push_back({event.at, palette.coin, 2});
            return burst(event.at, 26, 2, 7, 1, {.color = palette.coin, .size = 0.09, .drag = 2, .life = 45});
        case EventKind::Oil: return burst(event.at, 14, 1, 4, 2, {.color = fire, .size = 0.08, .drag = 2, .life = 35});
        case EventKind::Bumped: return;
        case EventKind::LampLit:
            rings_.push_back({event.at, fire, 1.4});
            return burst(event.at + Vec2(0, 0.7), 10, 1, 4, 3, {.color = fire, .size = 0.07, .gravity = 9, .life = 34});
        case EventKind::BrickBroke:
            return burst(event.at, 12, 2, 6, 4,
                         {.color = palette.brick, .size = 0.17, .gravity = 24, .life = 50, .square = true});
        case EventKind::LanternLit:
            rings_.push_back({event.at + Vec2(0, 0.9), fire, 3});
            return burst(event.at + Vec2(0, 0.9), 22, 1, 5, 2, {.color = fire, .size = 0.08, .drag = 2, .life = 45});
        case EventKind::Hurt:
            return burst(event.at, 16, 2, 5, 2, {.color = fire, .size = 0.1, .gravity = 8, .life = 34});
        case EventKind::Died:
            return burst(
                event.at, 22, 0.4, 2, 1.6,
                {.color = Color::hex(0xc8ccd8).faded(0.7), .size = 0.16, .drag = 2, .growth = 0.3, .life = 60});
        case EventKind::Finished:
            rings_.push_back({event.at + Vec2(0, 2.4), fire, 6});
            return burst(event.at + Vec2(0, 2.4), 60, 2, 9, 2, {.color = fire, .size = 0.11, .gravity = 4, .life = 80});
    }
}

void Effects::update() {
    for (Bit& bit : bits_) {
        bit.velocity += Vec2(0, -bit.gravity * tickSeconds);
        bit.velocity *= 1 - bit.drag * tickSeconds;
        bit.at += bit.velocity * tickSeconds;
        bit.size += bit.growth * tickSeconds;
        bit.angle += bit.spin;
        ++bit.age;
    }
    for (Words& words : words_) {
        words.at += Vec2(0, 1.6 * tickSeconds * (1 - shareOf(words.age, wordsLife)));
        ++words.age;
    }
    for (Ring& ring : rings_) ++ring.age;
    std::erase_if(bits_, [](const Bit& bit) { return bit.age > bit.life; });
    std::erase_if(words_, [](const Words& words) { return words.age > wordsLife; });
    std::erase_if(rings_, [](const Ring& ring) { return ring.age > ringLife; });
}

void Effects::draw(Canvas& canvas) const {
    for (const Ring& ring : rings_) {
        const double share = shareOf(ring.age, ringLife), out = 1 - (1 - share) * (1 - share);
        canvas.circle(ring.at, 0.2 + ring.reach * out,
                      stroke(ring.color.faded(0.8 * (1 - share)), 0.16 * (1 - share) + 0.01));
    }
    for (const Bit& bit : bits_) {
        const double share = shareOf(bit.age, bit.life);
        const Color color = bit.color.faded(1 - share * share);
        if (bit.square) {
            const auto place = canvas.place({.position = bit.at, .angle = bit.angle});
            canvas.box({0, 0}, {bit.size, bit.size}, color, 0.03);
        } else {
            canvas.circle(bit.at, bit.size * (bit.growth > 0 ? 1 : 1 - 0.6 * share), color);
        }
    }
    for (const Words& words : words_) {
        const double share = shareOf(words.age, wordsLife);
        // They shrink and do not fade: where words are half transparent, their dark edge shows through.
        const double shrunk = share < 0.6 ? 1 : (1 - share) / 0.4;
        const TextStyle style{.size = 0.55 * shrunk,
                              .color = words.color,
                              .align = Align::Center,
                              .baseline = Baseline::Middle,
                              .weight = Weight::Heavy};
        TextStyle shade = style;
        shade.color = Color::hex(0x1b1626);
        for (const Vec2& aside : {Vec2(-0.04, 0), Vec2(0.04, 0), Vec2(0, 0.04), Vec2(0, -0.06)})
            canvas.text(words.at + shrunk * aside, words.text, shade);
        canvas.text(words.at, words.text, style);
    }
}

}  // namespace plumb::games::runner
