// SPDX-License-Identifier: MIT
#include <games/artillery/draw.h>

#include <algorithm>
#include <cmath>

#include <games/artillery/palette.h>
#include <games/frame/game.h>
#include <plumb/kinematics/linear_drag.h>

namespace plumb::games::artillery {
namespace {

constexpr int apart = 4;  ///< between two dots [ticks]

/// For how many ticks of the forecast the shell exists.
int lifeOf(const Forecast& path, const Weapon& weapon, const Battle& battle) {
    int life = static_cast<int>(path.poses.size()) - 1;
    if (weapon.fuse > 0) life = std::min(life, weapon.fuse);
    if (weapon.fuse == 0 && !path.hits.empty()) life = std::min(life, path.hits.front().tick);
    for (int tick = 0; tick < life; ++tick)
        if (path.poses[static_cast<std::size_t>(tick)].position.y() < battle.sea()) life = tick;
    return life;
}

/// The latest time at which a shell is in the ground or in the sea if it hits nothing before. A longer forecast is not
/// needed [ticks].
int longestFlight(const Battle& battle, const Aim& aim) {
    const BodyDef shell = shellDef(battle.middleOf(battle.gunner()), aim, weapons[0]);
    const DragLaw law{dragRate, {battle.wind(), 0}, {0, -gravity}};
    int tick = 1;
    for (; tick < fullLine; tick += apart) {
        const Vec2 at = moveWithDrag({shell.position, shell.velocity}, law, tick * tickSeconds).position;
        if (at.y() < std::max(battle.terrain().heightAt(at.x()), battle.sea()) - shellRadius) break;
    }
    return tick;
}

}  // namespace

void drawAimLine(Canvas& canvas, const Battle& battle, int ticks, double seconds) {
    const Gunner& gunner = battle.gunner();
    const Weapon& weapon = weapons[static_cast<std::size_t>(gunner.weapon)];
    const int needed = weapon.fuse > 0 ? weapon.fuse : longestFlight(battle, gunner.aim);
    const Forecast path = battle.forecastOf(gunner.aim, gunner.weapon, std::min(ticks, needed));
    const int life = lifeOf(path, weapon, battle);
    const double march = std::fmod(seconds * 20, apart);
    for (double tick = march; tick < life; tick += apart) {
        const auto before = static_cast<std::size_t>(tick);
        const Vec2 from = path.poses[before].position, to = path.poses[before + 1].position;
        const Vec2 at = from + (to - from) * (tick - std::floor(tick));
        const double fade = ticks < fullLine ? 1 - tick / ticks : 1;
        canvas.circle(at, 0.22, ink.faded(0.55 * fade));
        canvas.circle(at, 0.15, (battle.charging() ? gold : paper).faded(fade));
    }
    if (life == ticks) return;
    const Vec2 end = path.poses[static_cast<std::size_t>(life)].position;
    canvas.circle(end, weapon.blast, stroke(gold.faded(0.5), 0.1));
    canvas.circle(end, 0.3, gold);
}

void Traces::update(const Battle& battle) {
    if (!battle.shell()) return;
    std::vector<Vec2>& points = points_[static_cast<std::size_t>(battle.crew())];
    if (battle.shell()->age <= 1) points.clear();
    if (battle.shell()->age % 3 == 1) points.push_back(battle.world().body(battle.shell()->body).position());
}

void Traces::draw(Canvas& canvas, int crew) const {
    for (const Vec2& point : points_[crew == 0 ? 0 : 1])
        canvas.circle(point, 0.11, lighter(crewColor(crew), 0.35).faded(0.5));
}

}  // namespace plumb::games::artillery
