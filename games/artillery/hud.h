// SPDX-License-Identifier: MIT
// Which texts, signs and bars are drawn over the picture?
#pragma once
#include <optional>
#include <string>

#include <games/artillery/arrangement.h>
#include <games/artillery/battle.h>
#include <games/artillery/match.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

struct Hud {
    const Match& match;
    std::string stage;   ///< the island's name
    std::string rivals;  ///< who plays the other crew
    int answer = 0;      ///< how long the sign of the turn still answers a press [ticks]
    double seconds = 0;

    const Battle& battle() const { return match.battle(); }
};

void drawHud(Canvas& canvas, const Hud& hud, const Arrangement& arrangement);
/// A band across the middle, on top of everything, when a battle is won or lost.
void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds);

/// Whose turn it is, in a few words, such as "Your turn", "The Tides aim" or "The Tides' shell flies". Empty when the
/// battle is over.
std::string turnText(const Match& match);

/// The answer to a press in the rival's turn. It is shown in place of turnText() for a moment.
class Answer {
public:
    /// One tick; pressed: was a button pressed in it? Returns whether an answer begins.
    bool update(const Match& match, bool pressed);
    int ticksLeft() const { return left_; }
    /// Such as "Wait: the Tides aim".
    static std::string text(const Match& match);

private:
    int left_ = 0;  ///< [ticks]
};

/// The arrow at the picture's edge to a shell that is out of sight.
struct ShellMark {
    Vec2 tip{0, 0};      ///< of the arrow, in the world [m]
    Vec2 towards{0, 1};  ///< the direction to the shell, of length 1
    std::string text;    ///< such as "41 m high" or "12 m away"
};

/// None while the shell is in sight. seen: the visible part of the world; inner: where arrows may be; sea: its height.
std::optional<ShellMark> shellMarkOf(const Vec2& shell, const Aabb& seen, const Aabb& inner, double sea);

/// Draws the arrow in world units, with the current camera. at: where the shell is drawn.
void drawShellMark(Canvas& canvas, const Battle& battle, const Vec2& at, const Arrangement& arrangement);

}  // namespace plumb::games::artillery
