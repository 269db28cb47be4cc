// SPDX-License-Identifier: MIT
// Where does the camera look?
#pragma once
#include <algorithm>

#include <games/artillery/battle.h>
#include <games/frame/camera.h>

namespace plumb::games::artillery {

inline constexpr double fieldHeight = 37;  ///< height of the view of the whole island [m]
inline constexpr double fieldBottom = -5;  ///< lower edge of that view [m]

/// The camera is close to the gunner when a turn begins, and shows the whole island while the gunner aims. It shows
/// more when a shell would leave the picture, moves closer where the shell comes down, and closest where it exploded.
class Eye {
public:
    Eye();
    void update(const Battle& battle);  ///< one tick
    void shake(double strength) { shake_ = std::min(1.5, shake_ + strength); }
    void lookAt(const Vec2& place) { place_ = place; }  ///< the place to show in Phase::Settle

    Camera camera(double between) const;
    /// For distant scenery: it moves only by this share.
    Camera farCamera(double between, double share) const;

private:
    Camera wanted(const Battle& battle) const;

    Camera now_, before_;
    Vec2 place_{0, 5};
    double shake_ = 0;
    int ticks_ = 0;
};

}  // namespace plumb::games::artillery
