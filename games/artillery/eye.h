// SPDX-License-Identifier: MIT
// Where does one look?
#pragma once
#include <algorithm>

#include <games/artillery/battle.h>
#include <games/frame/camera.h>

namespace plumb::games::artillery {

inline constexpr double fieldHeight = 37;  ///< of what is seen when all is seen [m]
inline constexpr double fieldBottom = -5;  ///< [m]

/// Near whose turn begins; at all of the island while someone aims; higher when a shell flies out of the picture;
/// nearer where it comes down, and nearer still where it went off.
class Eye {
public:
    Eye();
    void update(const Battle& battle);  ///< one tick
    void shake(double strength) { shake_ = std::min(1.5, shake_ + strength); }
    void lookAt(const Vec2& place) { place_ = place; }  ///< where something is to be seen when all settles

    Camera camera(double between) const;
    /// Of what is far off: it moves by so much less.
    Camera farCamera(double between, double share) const;

private:
    Camera wanted(const Battle& battle) const;

    Camera now_, before_;
    Vec2 place_{0, 5};
    double shake_ = 0;
    int ticks_ = 0;
};

}  // namespace plumb::games::artillery
