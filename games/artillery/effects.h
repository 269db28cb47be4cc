// SPDX-License-Identifier: MIT
// Which particles and numbers appear, for the picture only?
#pragma once
#include <string>
#include <vector>

#include <games/artillery/happening.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>
#include <plumb/kinematics/point_motion.h>
#include <plumb/math/random.h>

namespace plumb::games::artillery {

/// Clods, smoke, sparks, drops. kinematics/linear_drag.h gives each position from the age, without time steps.
class Effects {
public:
    void begin(const Happening& happening, const Palette& palette);
    void trail(const Vec2& shell);                       ///< behind a shell, each tick
    void celebrate(const Vec2& at, const Color& color);  ///< one rocket that bursts
    void update();                                       ///< one tick
    void draw(Canvas& canvas, double wind) const;
    void drawLabels(Canvas& canvas) const;  ///< the damage done, as numbers

private:
    struct Range {
        double least, most;
    };
    struct Bit {
        PointMotion from{};
        double life = 1;              ///< [s]
        double size = 0.2, grow = 0;  ///< [m], [m/s]
        double drag = 1;              ///< [1/s]
        double fall = 1;              ///< share of gravity [-]
        Color color{};
        double age = 0;  ///< [s]
        bool ring = false;
    };
    struct Label {
        Vec2 at;
        int amount = 0, crew = 0;
        double age = 0;
    };
    /// Many particles of one kind, each slightly different.
    struct Burst {
        int count = 1;
        Range speed{1, 2};     ///< [m/s]
        Range angle{0, 6.28};  ///< [rad]
        Bit bit{};
    };
    void burst(const Vec2& at, const Burst& burst);
    void spot(const Vec2& at, const Bit& bit);  ///< one particle that does not move
    void explode(const Vec2& at, double size, const Palette& palette);
    void fire(const Vec2& at, const Vec2& along);
    void splash(const Vec2& at, const Color& foam);
    void die(const Vec2& at, int crew);
    void dust(const Vec2& at, int count, double size);
    void label(const Happening& happening);
    void drawLabel(Canvas& canvas, const Label& label, double age) const;

    std::vector<Bit> bits_;
    std::vector<Label> labels_;
    Random random_{7};
};

}  // namespace plumb::games::artillery
