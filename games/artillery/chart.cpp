// SPDX-License-Identifier: MIT
#include <games/artillery/draw.h>

#include <algorithm>

namespace plumb::games::artillery {
namespace {

constexpr double reach = 35;     ///< from the middle of the island to the chart's edge [m]
constexpr double lowest = -1.5;  ///< height at the chart's lower edge [m]
constexpr double edge = 8;       ///< from the chart to the picture's edge [units of the screen]
constexpr double across = (screenWidth - 2 * edge) / (2 * reach);  ///< [units of the screen / m]
constexpr double upwards = 0.6 * across;  ///< lower than it is, so that a high shell is on it too

class Chart {
public:
    Chart(Canvas& canvas, const Battle& battle, double top) : canvas_(canvas), battle_(battle), top_(top) {}

    void draw(const Palette& palette, const Aabb& seen) const {
        canvas_.rect({edge, top_}, {screenWidth - 2 * edge, chartHeight}, ink.faded(0.55), 9);
        const auto clip = canvas_.clip({edge, top_}, {screenWidth - 2 * edge, chartHeight});
        drawGround(palette);
        for (const Gunner& gunner : battle_.gunners())
            if (gunner.alive) drawGunner(gunner);
        drawFrame(seen);
        if (const auto& shell = battle_.shell()) drawShell(battle_.world().body(shell->body).position());
    }

private:
    Vec2 place(const Vec2& at) const {
        return {edge + (at.x() + reach) * across, top_ + chartHeight - (at.y() - lowest) * upwards};
    }

    /// At the chart's edge when it is outside.
    Vec2 within(const Vec2& at, double radius) const {
        return {std::clamp(at.x(), edge + radius, screenWidth - edge - radius), std::max(at.y(), top_ + radius)};
    }

    void drawGround(const Palette& palette) const {
        const Vec2 corner = place({-reach, battle_.sea()});
        canvas_.rect(corner, {screenWidth - 2 * edge, top_ + chartHeight - corner.y()}, palette.sea);
        std::vector<Vec2> outline{place({-reach, lowest})};
        for (double x = -reach; x <= reach; x += 0.5)
            outline.push_back(place({x, std::max(lowest, battle_.terrain().heightAt(x))}));
        outline.push_back(place({reach, lowest}));
        canvas_.polygon(std::move(outline), mix(palette.turf, palette.earthTop, 0.3));
    }

    void drawGunner(const Gunner& gunner) const {
        const Vec2 at = within(place(battle_.middleOf(gunner)), 10);
        const bool active = &gunner == &battle_.gunner() && battle_.phase() != Phase::Over;
        canvas_.circle(at, active ? 10 : 8, active ? gold : ink);
        canvas_.circle(at, 6.5, crewColor(gunner.crew));
    }

    void drawFrame(const Aabb& seen) const {
        const Vec2 left = place(seen.lower), right = place(seen.upper);
        const double high = std::max(top_ + 1, right.y()), low = std::min(top_ + chartHeight - 1, left.y());
        if (low - high < 4) return;  // the camera follows a high shell
        canvas_.rect({left.x(), high}, {right.x() - left.x(), low - high}, stroke(paper.faded(0.7), 1.5), 4);
    }

    void drawShell(const Vec2& at) const { canvas_.circle(within(place(at), 7), 5, paper); }

    Canvas& canvas_;
    const Battle& battle_;
    double top_;
};

}  // namespace

void drawChart(Canvas& canvas, const Battle& battle, const Palette& palette, const Aabb& seen, double top) {
    Chart(canvas, battle, top).draw(palette, seen);
}

}  // namespace plumb::games::artillery
