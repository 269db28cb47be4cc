// SPDX-License-Identifier: MIT
// Where does the camera look?
#pragma once
#include <algorithm>

#include <games/artillery/arrangement.h>
#include <games/artillery/battle.h>
#include <games/frame/camera.h>

namespace plumb::games::artillery {

inline constexpr double fieldHeight = 37;  ///< height of the view of the whole island [m]
inline constexpr double fieldBottom = -5;  ///< lower edge of that view [m]

/// The camera is close to the gunner when a turn begins, and shows the whole island while the gunner aims. It shows
/// more when a shell would leave the picture, moves closer where the shell comes down, and closest where it exploded.
/// In an upright window the whole island would be small. There the camera shows what lies before the gunner who aims,
/// and then follows the shell.
class Eye {
public:
    Eye();
    void update(const Battle& battle);  ///< one tick
    void shake(double strength) { shake_ = std::min(1.5, shake_ + strength); }
    void lookAt(const Vec2& place) { place_ = place; }  ///< the place to show in Phase::Settle

    Camera camera(double between, const Arrangement& arrangement) const;

private:
    /// What an upright window shows in the middle of its field.
    struct Look {
        Vec2 at{0, 8};      ///< [m]
        double width = 60;  ///< of the picture [m]
    };

    Camera wanted(const Battle& battle) const;
    Look wantedUpright(const Battle& battle) const;
    Camera uprightCamera(double between, const Arrangement& arrangement) const;

    Camera now_, before_;
    Look look_, lookBefore_;
    Vec2 place_{0, 5};
    double shake_ = 0;
    int ticks_ = 0;
};

/// The camera of distant scenery: it moves only by this share of the other's motion.
Camera farCamera(const Camera& camera, double share);

}  // namespace plumb::games::artillery
