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

/// The kit's forecast of the shell in so many ticks, up to where it goes off; it is made when it is drawn, from the
/// world as it then is.
void drawAimLine(Canvas& canvas, const Battle& battle, int ticks, double seconds);

/// Where the last shells of either crew flew.
class Traces {
public:
    void update(const Battle& battle);  ///< one tick
    void draw(Canvas& canvas, int crew) const;

private:
    std::array<std::vector<Vec2>, 2> points_;
};

}  // namespace plumb::games::artillery
