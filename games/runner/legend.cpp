// SPDX-License-Identifier: MIT
#include <games/runner/legend.h>

namespace plumb::games::runner {
namespace {

Tile full(TileKind kind, Tag tag = Ground) {
    return {.form = TileForm::Full, .kind = kind, .tag = tag};
}
Tile slope(TileForm form) {
    return {.form = form};
}

}  // namespace

const std::vector<Letter>& legend() {
    static const std::vector<Letter> letters{
        {'.', "air", {}},
        {' ', "air", {}},
        {'#', "ground", full(TileKind::Solid)},
        {'=', "a ledge, solid from above only", full(TileKind::OneWay)},
        {'/', "a slope that rises by one in one", slope(TileForm::SlopeUp)},
        {'\\', "a slope that falls by one in one", slope(TileForm::SlopeDown)},
        {'1', "the low half of a slope that rises by one in two", slope(TileForm::GentleUpLow)},
        {'2', "the high half of a slope that rises by one in two", slope(TileForm::GentleUpHigh)},
        {'3', "the high half of a slope that falls by one in two", slope(TileForm::GentleDownHigh)},
        {'4', "the low half of a slope that falls by one in two", slope(TileForm::GentleDownLow)},
        {'^', "thorns", full(TileKind::Hazard)},
        {'~', "water, which puts the flame out", full(TileKind::Sensor)},
        {'b', "a brick; break it from below", full(TileKind::Solid, Brick)},
        {'?', "a lamp with something in it; light it from below", full(TileKind::Solid, Lamp)},
        {'o', "a coin", {}, ThingKind::Coin},
        {'*', "a sun; each level hides three", {}, ThingKind::Sun},
        {'!', "a drop of oil", {}, ThingKind::Oil},
        {'x', "a crate", {}, ThingKind::Crate},
        {'s', "a spring", {}, ThingKind::Spring},
        {'w', "a snuffer, which walks", {}, ThingKind::Snuffer},
        {'u', "a burr, which walks and has thorns", {}, ThingKind::Burr},
        {'m', "a moth, which flies", {}, ThingKind::Moth},
        {'C', "a lantern, the checkpoint", {}, ThingKind::Lantern},
        {'G', "the beacon, the end", {}, ThingKind::Beacon},
    };
    return letters;
}

const Letter* find(char letter) {
    for (const Letter& entry : legend())
        if (entry.letter == letter) return &entry;
    return nullptr;
}

std::string allLetters() {
    std::string letters;
    for (const Letter& entry : legend()) letters += entry.letter;
    return letters + startLetter + platformLetter + std::string(trackLetters);
}

}  // namespace plumb::games::runner
