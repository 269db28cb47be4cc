// SPDX-License-Identifier: MIT
#include <games/maze/lookahead.h>

#include <algorithm>

#include <games/maze/lanes.h>

namespace plumb::games::maze {
namespace {

constexpr int near = 10;            ///< a hunter this close makes a power dot worth more [tiles]
constexpr int exitsOfCrossing = 3;  ///< a cell with fewer exits is no crossing
constexpr double worst = -1e9;
constexpr double haste = 0.3;  ///< an event in the last frame loses this share of its value

bool isDangerous(const Hunter& hunter) {
    return hunter.canMeet() && !hunter.frightened();
}

int huntersWithin(const Chase& chase, int tiles) {
    return static_cast<int>(std::count_if(chase.hunters().begin(), chase.hunters().end(), [&](const Hunter& hunter) {
        return hunter.canMeet() && lanes().distance(hunter.cell(), chase.player().cell()) <= tiles;
    }));
}

int wayToNearestDot(const Chase& chase) {
    int nearest = 1000;
    for (const Cell cell : lanes().cells())
        if (chase.hasDot(cell)) nearest = std::min(nearest, lanes().distance(cell, chase.player().cell()));
    return nearest;
}

}  // namespace

std::optional<Direction> Lookahead::best(const Chase& chase) const {
    std::optional<Direction> best;
    double most = worst;
    for (const Direction exit : lanes().exits(chase.player().cell())) {
        Chase copy = chase;
        copy.reseed(1);
        const double value = follow(std::move(copy), exit, 0) + (exit == chase.player().heading() ? 0.1 : 0);
        if (best && value <= most) continue;
        best = exit;
        most = value;
    }
    return best;
}

/// The value of one lane up to the next crossing, and of the best way from there.
double Lookahead::follow(Chase chase, Direction wanted, int frame) const {
    double value = 0;
    for (; frame < settings_.frames; ++frame) {
        const Cell before = chase.player().cell();
        chase.step(wanted);
        value += gain(chase, frame);
        if (chase.playerCaught() || chase.cleared()) return value;
        const Cell now = chase.player().cell();
        if (now == before) continue;
        const std::vector<Direction>& exits = lanes().exits(now);
        if (exits.size() >= exitsOfCrossing) return value + branch(chase, frame + 1);
        const Direction back = opposite(chase.player().heading());
        wanted = exits[0] == back ? exits[1] : exits[0];
    }
    return value + prospects(chase);
}

double Lookahead::branch(const Chase& chase, int frame) const {
    if (frame >= settings_.frames) return prospects(chase);
    double most = worst;
    for (const Direction exit : lanes().exits(chase.player().cell()))
        if (exit != opposite(chase.player().heading())) most = std::max(most, follow(chase, exit, frame));
    return most;
}

/// The value of the events of one frame; later events count less.
double Lookahead::gain(const Chase& chase, int frame) const {
    const double patience = 1 - haste * frame / settings_.frames;
    double value = 0;
    for (const ChaseEvent& event : chase.events()) switch (event.kind) {
            case Happening::Dot: value += settings_.dot; break;
            case Happening::Power: value += settings_.power * (1 + huntersWithin(chase, near)); break;
            case Happening::HunterCaught: value += settings_.hunter; break;
            case Happening::Fruit: value += settings_.fruit; break;
            case Happening::PlayerCaught: return frame - settings_.caught;
            default: break;
        }
    return value * patience;
}

/// The value of the situation after the last simulated frame.
double Lookahead::prospects(const Chase& chase) const {
    double value = -settings_.way * wayToNearestDot(chase);
    for (const Hunter& hunter : chase.hunters())
        if (isDangerous(hunter))
            value -= settings_.nearness / (1 + lanes().distance(hunter.cell(), chase.player().cell()));
    return value;
}

}  // namespace plumb::games::maze
