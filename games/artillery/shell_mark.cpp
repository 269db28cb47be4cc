// SPDX-License-Identifier: MIT
#include <games/artillery/hud.h>

#include <cmath>

#include <games/artillery/palette.h>

namespace plumb::games::artillery {
namespace {

/// The part of the world behind a part of the screen.
Aabb worldBehind(const Aabb& part, const Aabb& screen, const Aabb& world) {
    const Vec2 scale = (world.upper - world.lower).cwiseQuotient(screen.upper - screen.lower);
    const Vec2 left(world.lower.x() + (part.lower.x() - screen.lower.x()) * scale.x(),
                    world.upper.y() - (part.upper.y() - screen.lower.y()) * scale.y());
    const Vec2 right(world.lower.x() + (part.upper.x() - screen.lower.x()) * scale.x(),
                     world.upper.y() - (part.lower.y() - screen.lower.y()) * scale.y());
    return {left, right};
}

bool isWithin(const Vec2& point, const Aabb& box) {
    return point.cwiseMax(box.lower).cwiseMin(box.upper) == point;
}

std::string metres(double length) {
    return std::to_string(static_cast<int>(std::lround(length))) + " m";
}

}  // namespace

std::optional<ShellMark> shellMarkOf(const Vec2& shell, const Aabb& seen, const Aabb& inner, double sea) {
    if (isWithin(shell, seen)) return std::nullopt;
    const Vec2 tip = shell.cwiseMax(inner.lower).cwiseMin(inner.upper);
    const Vec2 edge = shell.cwiseMax(seen.lower).cwiseMin(seen.upper);
    const bool above = shell.y() > seen.upper.y();
    return ShellMark{tip, (shell - tip).normalized(),
                     above ? metres(shell.y() - sea) + " high" : metres((shell - edge).norm()) + " away"};
}

void drawShellMark(Canvas& canvas, const Battle& battle, const Vec2& at, const Arrangement& arrangement) {
    const Aabb world = canvas.visible();
    const double unit =
        (world.upper.x() - world.lower.x()) / (arrangement.screen.upper.x() - arrangement.screen.lower.x());
    const double large = arrangement.upright ? 1.6 * unit : unit;
    const Aabb field = worldBehind(arrangement.field, arrangement.screen, world);
    const auto mark = shellMarkOf(at, arrangement.upright ? field : world, inflate(field, -12 * unit), battle.sea());
    if (!mark) return;
    const Vec2 along = mark->towards, across = perp(along);
    const auto arrow = [&](double grown) {
        return std::vector<Vec2>{mark->tip + (2 + grown) * large * along,
                                 mark->tip + large * (-18 - grown) * along + (12 + grown) * large * across,
                                 mark->tip - 12 * large * along,
                                 mark->tip + large * (-18 - grown) * along - (12 + grown) * large * across};
    };
    canvas.polygon(arrow(3), ink);
    canvas.polygon(arrow(0), lighter(crewColor(battle.crew()), 0.3));
    const Vec2 half(36 * large, 9 * large);
    const Aabb room{field.lower + half + Vec2(6, 6) * unit, field.upper - half - Vec2(6, 6) * unit};
    const Vec2 label =
        (mark->tip - 24 * large * along - half.cwiseProduct(along)).cwiseMax(room.lower).cwiseMin(room.upper);
    canvas.box(label, half, ink.faded(0.72), 9 * large);
    canvas.text(label, mark->text,
                {.size = 12 * large,
                 .color = paper,
                 .align = Align::Center,
                 .baseline = Baseline::Middle,
                 .weight = Weight::Bold});
}

}  // namespace plumb::games::artillery
