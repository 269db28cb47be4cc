// SPDX-License-Identifier: MIT
// How are the aim line and the last shot's trace drawn?
#pragma once
#include <array>
#include <vector>

#include <games/artillery/battle.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

inline constexpr int shortLine = 52;  ///< [ticks]
inline constexpr int fullLine = 540;

/// Draws the kit's forecast of the shell for this many ticks, at most up to the explosion. The forecast is made here,
/// from the current world.
void drawAimLine(Canvas& canvas, const Battle& battle, int ticks, double seconds);

/// The path of each crew's last shell.
class Traces {
public:
    void update(const Battle& battle);  ///< one tick
    void draw(Canvas& canvas, int crew) const;

private:
    std::array<std::vector<Vec2>, 2> points_;
};

}  // namespace plumb::games::artillery
