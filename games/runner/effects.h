// SPDX-License-Identifier: MIT
// Which dust, sparks and splinters fly, for the picture only?
#pragma once
#include <string>
#include <vector>

#include <games/frame/canvas.h>
#include <games/frame/game.h>
#include <games/runner/event.h>
#include <plumb/math/random.h>

namespace plumb::games::runner {

struct Palette;

class Effects {
public:
    void hear(const Event& event, const Palette& palette);
    /// Shows words that rise and fade.
    void say(const Vec2& at, std::string words, const Color& color);
    void trail(const Vec2& at, const Vec2& velocity, const Color& color);  ///< one spark from the flame
    void update();                                                         ///< one tick
    void draw(Canvas& canvas) const;
    void clear();

private:
    struct Bit {
        Vec2 at{0, 0}, velocity{0, 0};
        Color color{};
        double size = 0.1;  ///< [m]
        double gravity = 0, drag = 0;
        double growth = 0;  ///< of the size [m/s]
        int life = 30, age = 0;
        bool square = false;
        double angle = 0, spin = 0;
    };
    struct Words {
        Vec2 at;
        std::string text;
        Color color{};
        int age = 0;
    };
    struct Ring {
        Vec2 at;
        Color color{};
        double reach = 1;
        int age = 0;
    };

    /// Throws count bits in random directions, with speeds uniform from slow to fast, plus lift upwards [m/s].
    void burst(const Vec2& at, int count, double slow, double fast, double lift, Bit like);
    void dust(const Vec2& at, int count, double strength, const Color& color);

    Random random_{7};
    std::vector<Bit> bits_;
    std::vector<Words> words_;
    std::vector<Ring> rings_;
};

}  // namespace plumb::games::runner
