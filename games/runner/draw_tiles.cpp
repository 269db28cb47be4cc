// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <games/runner/draw.h>

namespace plumb::games::runner {
namespace {

constexpr double lap = 0.02;     ///< overlap of neighbours, so that no seam is visible [m]
constexpr double rim = 0.2;      ///< height of the turf [m]
constexpr double soilFoot = -2;  ///< height at which the soil is darkest [m]

class TilePainter {
public:
    TilePainter(Canvas& canvas, const Scene& scene)
        : canvas_(canvas), scene_(scene), palette_(scene.palette), tiles_(scene.stage.tiles()) {
        const Aabb seen = canvas.visible();
        first_ = tiles_.cellAt(seen.lower);
        last_ = tiles_.cellAt(seen.upper);
    }

    void draw() {
        eachCell([&](Cell cell, const Tile& tile) { drawThorns(cell, tile); });
        for (int row = first_.row - 1; row <= last_.row; ++row) drawGroundRow(row);
        eachCell([&](Cell cell, const Tile& tile) { drawSlope(cell, tile); });
        eachCell([&](Cell cell, const Tile& tile) { drawSpecks(cell, tile); });
        eachCell([&](Cell cell, const Tile& tile) { drawTurf(cell, tile); });
        eachCell([&](Cell cell, const Tile& tile) { drawBlock(cell, tile); });
    }

    void drawLamps() {
        eachCell([&](Cell cell, const Tile& tile) {
            if (tile.tag == Lamp) drawBlock(cell, tile);
        });
    }

private:
    template <class Visit>
    void eachCell(Visit&& visit) const {
        for (int row = first_.row; row <= last_.row; ++row)
            for (int column = first_.column; column <= last_.column; ++column) {
                const Tile tile = at({column, row});
                if (!isEmpty(tile)) visit(Cell{column, row}, tile);
            }
    }

    /// The ground continues beyond the sides of the map and below it.
    Tile at(Cell cell) const {
        if (cell.row >= tiles_.rows()) return {};
        return tiles_.at({std::clamp(cell.column, 0, tiles_.columns() - 1), std::max(cell.row, 0)});
    }
    bool isGround(Cell cell) const {
        const Tile tile = at(cell);
        return isSolid(tile) && tile.tag == Ground && tile.kind == TileKind::Solid;
    }
    bool isFullGround(Cell cell) const { return isGround(cell) && at(cell).form == TileForm::Full; }
    /// Darker with depth. All cells share one gradient, so no edges are visible between them.
    Paint soil() const { return Paint::linear({0, soilTop()}, palette_.soil, {0, soilFoot}, palette_.deep); }
    Color speck(double height) const {
        const double depth = (soilTop() - height) / (soilTop() - soilFoot);
        return darker(mix(palette_.soil, palette_.deep, std::clamp(depth, 0.0, 1.0)), 0.16);
    }
    double soilTop() const { return 0.36 * tiles_.rows(); }
    double chance(Cell cell, int salt) const {
        const double x = std::sin(cell.column * 12.9898 + cell.row * 78.233 + salt * 37.7) * 43758.5453;
        return x - std::floor(x);
    }

    void drawGroundRow(int row) const {
        for (int column = first_.column - 1; column <= last_.column + 1;) {
            if (!isFullGround({column, row})) {
                ++column;
                continue;
            }
            const int begin = column;
            while (column <= last_.column + 1 && isFullGround({column, row})) ++column;
            const double left = isGround({begin - 1, row}) ? lap : 0, right = isGround({column, row}) ? lap : 0;
            canvas_.rect(Vec2(begin - left, row - lap), Vec2(column - begin + left + right, 1 + lap), soil());
        }
    }

    void drawSlope(Cell cell, const Tile& tile) const {
        if (tile.form == TileForm::Full || !isGround(cell)) return;
        std::vector<Vec2> corners = tiles_.cornersOf(cell);
        for (Vec2& corner : corners) {
            if (corner.y() < cell.row + lap) corner.y() -= lap;
            corner.x() += corner.x() < cell.column + 0.5 ? -lap : lap;
        }
        canvas_.polygon(std::move(corners), soil());
    }

    void drawSpecks(Cell cell, const Tile& tile) const {
        if (tile.form != TileForm::Full || !isGround(cell)) return;
        for (int i = 0; i < 2; ++i) {
            const Vec2 at =
                tiles_.lowerLeft(cell) + Vec2(0.15 + 0.7 * chance(cell, i), 0.15 + 0.55 * chance(cell, i + 9));
            canvas_.ellipse(at, {0.08 + 0.1 * chance(cell, i + 20), 0.05 + 0.04 * chance(cell, i + 30)}, speck(at.y()));
        }
    }

    void drawTurf(Cell cell, const Tile& tile) const {
        if (!isGround(cell)) return;
        const Vec2 corner = tiles_.lowerLeft(cell);
        if (tile.form != TileForm::Full) return drawSlopeTurf(cell, tile);
        if (isGround({cell.column, cell.row + 1})) return;
        const bool left = isGround({cell.column - 1, cell.row}), right = isGround({cell.column + 1, cell.row});
        const double from = corner.x() - (left ? lap : 0.06), to = corner.x() + 1 + (right ? lap : 0.06);
        canvas_.rect({from, corner.y() + 1 - rim}, {to - from, rim}, palette_.turf, left && right ? 0 : 0.06);
        canvas_.rect({from, corner.y() + 1 - 0.07}, {to - from, 0.07}, palette_.turfLight, 0.02);
        for (int i = 0; i < 3; ++i) {
            const double x = corner.x() + (i + 0.2 + 0.6 * chance(cell, i)) / 3,
                         tall = 0.08 + 0.12 * chance(cell, i + 5);
            canvas_.polygon({{x - 0.07, corner.y() + 1 - rim + 0.01},
                             {x + 0.07, corner.y() + 1 - rim + 0.01},
                             {x, corner.y() + 1 - rim - tall}},
                            palette_.turf);
        }
        if (chance(cell, 77) < 0.3) drawTuft(corner + Vec2(0.2 + 0.6 * chance(cell, 3), 1), chance(cell, 8));
    }

    void drawTuft(const Vec2& foot, double kind) const {
        const double sway = 0.05 * std::sin(scene_.time * 2 + foot.x());
        for (const double aside : {-0.12, 0.0, 0.12})
            canvas_.line(foot + Vec2(aside * 0.4, 0), foot + Vec2(aside + sway, 0.22 - std::fabs(aside)), palette_.turf,
                         0.045);
        if (kind > 0.7) canvas_.circle(foot + Vec2(sway, 0.26), 0.07, palette_.light);
    }

    void drawSlopeTurf(Cell cell, const Tile& tile) const {
        const auto line = [&](double left, double right) {
            const Vec2 corner = tiles_.lowerLeft(cell);
            const Vec2 from = corner + Vec2(-lap, left - 0.09), to = corner + Vec2(1 + lap, right - 0.09);
            canvas_.line(from, to, palette_.turf, rim);
            canvas_.line(from + Vec2(0, 0.07), to + Vec2(0, 0.07), palette_.turfLight, 0.06);
        };
        switch (tile.form) {
            case TileForm::SlopeUp: return line(0, 1);
            case TileForm::SlopeDown: return line(1, 0);
            case TileForm::GentleUpLow: return line(0, 0.5);
            case TileForm::GentleUpHigh: return line(0.5, 1);
            case TileForm::GentleDownHigh: return line(1, 0.5);
            case TileForm::GentleDownLow: return line(0.5, 0);
            default: return;
        }
    }

    void drawBlock(Cell cell, const Tile& tile) const {
        const Vec2 corner = tiles_.lowerLeft(cell);
        if (tile.kind == TileKind::OneWay) return drawLedge(cell, corner);
        if (tile.tag == Ground) return;
        const int since = scene_.stage.ticksSinceBump(cell);
        const double lift = since < 12 ? 0.25 * std::sin(since / 12.0 * 3.14159) : 0;
        const auto place = canvas_.place({.position = corner + Vec2(0.5, 0.5 + lift)});
        if (tile.tag == Brick)
            drawBrick();
        else
            drawLamp(tile.tag == Lamp);
    }

    void drawBrick() const {
        canvas_.box({0, 0}, {0.5, 0.5}, darker(palette_.brick, 0.35), 0.08);
        const auto stone = [&](double x, double y, double width) {
            canvas_.rect({x, y}, {width, 0.4}, palette_.brick, 0.07);
            canvas_.rect({x + 0.04, y + 0.31}, {width - 0.08, 0.05}, lighter(palette_.brick, 0.3), 0.02);
        };
        stone(-0.46, 0.05, 0.56);
        stone(0.14, 0.05, 0.32);
        stone(-0.46, -0.45, 0.3);
        stone(-0.12, -0.45, 0.58);
    }

    void drawLamp(bool isDark) const {
        const Color frame = Color::hex(0x4a3b52), glass = isDark ? Color::hex(0xffb84d) : Color::hex(0x7d7486);
        const double pulse = 0.5 + 0.5 * std::sin(scene_.time * 4);
        if (isDark)
            canvas_.circle({0, 0}, 0.95, Paint::radial({0, 0}, glass.faded(0.25 + 0.2 * pulse), 0.95, glass.faded(0)));
        canvas_.box({0, 0}, {0.5, 0.5}, frame, 0.12);
        canvas_.box({0, 0}, {0.37, 0.37}, isDark ? mix(glass, Color::hex(0xfff0b0), 0.5 * pulse) : glass, 0.08);
        canvas_.box({0, 0.4}, {0.28, 0.03}, lighter(frame, 0.3), 0.02);
        if (isDark) drawFlame(canvas_, {0, -0.24}, 0.5, 0, scene_.time);
    }

    void drawLedge(Cell cell, const Vec2& corner) const {
        const bool left =
            at({cell.column - 1, cell.row}).kind == TileKind::OneWay && !isEmpty(at({cell.column - 1, cell.row}));
        const bool right =
            at({cell.column + 1, cell.row}).kind == TileKind::OneWay && !isEmpty(at({cell.column + 1, cell.row}));
        const double from = corner.x() - (left ? lap : 0.04), to = corner.x() + 1 + (right ? lap : 0.04);
        canvas_.rect({from, corner.y() + 0.62}, {to - from, 0.38}, palette_.ledge, left && right ? 0 : 0.1);
        canvas_.rect({from, corner.y() + 0.88}, {to - from, 0.12}, lighter(palette_.ledge, 0.35),
                     left && right ? 0 : 0.05);
        canvas_.line(corner + Vec2(0.5, 0.65), corner + Vec2(0.5, 0.84), darker(palette_.ledge, 0.25), 0.04);
        if (!left || !right)
            canvas_.polygon({corner + Vec2(left ? 0.75 : 0.05, 0.63), corner + Vec2(left ? 0.95 : 0.25, 0.63),
                             corner + Vec2(left ? 0.95 : 0.05, 0.3)},
                            darker(palette_.ledge, 0.3));
    }

    void drawThorns(Cell cell, const Tile& tile) const {
        if (tile.kind != TileKind::Hazard) return;
        const Vec2 corner = tiles_.lowerLeft(cell);
        for (int i = 0; i < 3; ++i) {
            const double x = corner.x() + (i + 0.5) / 3, tall = 0.82 + 0.16 * chance(cell, i);
            const Vec2 tip(x + 0.08 * (chance(cell, i + 4) - 0.5), corner.y() + tall);
            canvas_.polygon({{x - 0.2, corner.y()}, {x + 0.2, corner.y()}, tip}, palette_.thorn);
            canvas_.polygon({{x - 0.2, corner.y()}, {x - 0.06, corner.y()}, tip}, lighter(palette_.thorn, 0.3));
        }
    }

    Canvas& canvas_;
    const Scene& scene_;
    const Palette& palette_;
    const TileMap& tiles_;
    Cell first_, last_;
};

}  // namespace

void drawTiles(Canvas& canvas, const Scene& scene) {
    TilePainter(canvas, scene).draw();
}

void drawLamps(Canvas& canvas, const Scene& scene) {
    TilePainter(canvas, scene).drawLamps();
}

}  // namespace plumb::games::runner
