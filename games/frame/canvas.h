// SPDX-License-Identifier: MIT
// How does a game draw?
#pragma once
#include <string>
#include <vector>

#include <games/frame/camera.h>
#include <games/frame/drawing.h>

namespace plumb::games {

// Which layers does a drawing have, from the lowest to the highest?
// Values for Canvas::layer(). A game uses any layer below these, and hudLayer.
inline constexpr int debugLayer = 1'000'000;  ///< the debug view of F1
inline constexpr int hudLayer = 2'000'000;    ///< information for players, so that F1 does not draw over it
inline constexpr int menuLayer = 3'000'000;
inline constexpr int footerLayer = 4'000'000;  ///< below the picture; it hides marks that reach down there

/// How a part of a picture is placed: scaled, then turned, then shifted.
struct Place {
    Vec2 position{0, 0};
    double angle = 0;  ///< from +x towards +y [rad]
    Vec2 scale{1, 1};  ///< (-1, 1) mirrors left and right [-]
    double opacity = 1;
};

/// What covers the game. Behind a menu, a game draws no banner: the menu would hide or contradict it. Behind the title,
/// it draws no information for players either: nobody plays then.
enum class Behind { Nothing, Menu, Title };

/// Collects marks. It begins with the units of the screen; look() changes to the world of a camera, screen() changes
/// back. In one layer, later marks lie above earlier ones. A higher layer always lies above a lower one.
class Canvas {
public:
    explicit Canvas(PixelSize size, double between = 1);

    /// The part of a tick that has passed since the last tick [-]. 0: draw things where they were before that tick;
    /// 1: draw them where they are after it. It is always 1 in a game that stands still.
    double between() const { return between_; }
    void setBetween(double share) { between_ = share; }
    Behind behind() const { return behind_; }
    void setBehind(Behind what) { behind_ = what; }
    PixelSize size() const { return drawing_.size; }

    // Each of the two ends all places and clips. The picture is the window without the rows of keepFree().
    void look(const Camera& camera);
    void screen();
    /// The camera of the last look().
    const Camera& camera() const { return camera_; }
    Aabb visible() const;          ///< the visible part of the world or of the screen, in the current units
    double unitsPerPixel() const;  ///< the width of the thinnest line that is seen well, in the current units
    void layer(int layer) { layer_ = layer; }
    /// From now on the picture ends this number of pixel rows above the window's lower edge. Calls screen().
    void keepFree(int rows);

    /// As long as the scope lives, everything is drawn in this place, or only within this rectangle.
    class Scope;
    [[nodiscard]] Scope place(const Place& place);
    [[nodiscard]] Scope clip(const Vec2& corner, const Vec2& size);

    void clear(const Paint& paint);  ///< fills the whole window; a gradient is in the current units
    /// corner: the one with the smallest x and y.
    void rect(const Vec2& corner, const Vec2& size, const Brush& brush, double radius = 0);
    void box(const Vec2& center, const Vec2& halfSize, const Brush& brush, double radius = 0);
    void circle(const Vec2& center, double radius, const Brush& brush);
    void ellipse(const Vec2& center, const Vec2& radii, const Brush& brush);
    /// From one angle to the other; angles are from +x towards +y [rad].
    void pie(const Vec2& center, double radius, double from, double to, const Brush& brush);
    void arc(const Vec2& center, double radius, double from, double to, const Brush& brush);
    void polygon(std::vector<Vec2> corners, const Brush& brush);
    void polyline(std::vector<Vec2> points, const Paint& paint, double width);
    void line(const Vec2& from, const Vec2& to, const Paint& paint, double width);
    void capsule(const Vec2& start, const Vec2& end, double radius, const Paint& paint);
    void text(const Vec2& at, std::string text, const TextStyle& style = {});

    const Drawing& drawing() const { return drawing_; }

private:
    struct State {
        Affine view;      ///< to pixels, without place()
        Affine toPixels;  ///< to pixels, with place()
        double opacity = 1;
        int clip = -1;
    };
    void add(decltype(Mark::shape) shape, const Brush& brush);

    Drawing drawing_;
    PixelSize picture_;
    State state_;
    Camera camera_;
    double between_;
    Behind behind_ = Behind::Nothing;
    int layer_ = 0;
};

/// Ends what place() or clip() began.
class Canvas::Scope {
public:
    ~Scope() { canvas_.state_ = before_; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

private:
    friend class Canvas;
    Scope(Canvas& canvas, const State& before) : canvas_(canvas), before_(before) {}
    Canvas& canvas_;
    State before_;
};

}  // namespace plumb::games
