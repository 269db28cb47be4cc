// SPDX-License-Identifier: MIT
// How does a game draw?
#pragma once
#include <string>
#include <vector>

#include <games/frame/camera.h>
#include <games/frame/drawing.h>

namespace plumb::games {

/// Where a part of a picture is put: scaled, then turned, then shifted.
struct Place {
    Vec2 position{0, 0};
    double angle = 0;  ///< from +x towards +y [rad]
    Vec2 scale{1, 1};  ///< (-1, 1) looks the other way [-]
    double opacity = 1;
};

/// What lies over the game: a banner would be hidden by a menu, or contradict it, and what is told to players is told
/// to nobody behind the title.
enum class Behind { Nothing, Menu, Title };

/// Keeps marks. It begins with the screen's units; look() changes to a camera's world, screen() back. What is drawn
/// later lies above, but for the layers, of which the higher lies above whatever was drawn when.
class Canvas {
public:
    explicit Canvas(PixelSize size, double between = 1);

    /// What share of a tick has passed since the last; 0: things are to be seen where they were before that tick,
    /// 1: where it brought them, which is where they are all the time in a game that stands still [-].
    double between() const { return between_; }
    void setBetween(double share) { between_ = share; }
    Behind behind() const { return behind_; }
    void setBehind(Behind what) { behind_ = what; }
    PixelSize size() const { return drawing_.size; }

    // Each ends all places and clips, and fills the picture: the window, but for what keepFree() leaves.
    void look(const Camera& camera);
    void screen();
    /// The one last looked through.
    const Camera& camera() const { return camera_; }
    Aabb visible() const;          ///< of the world, or screen, that is now drawn in
    double unitsPerPixel() const;  ///< of it; a line so wide is as thin as can be seen well
    void layer(int layer) { layer_ = layer; }
    /// From here on the picture ends so many rows of pixels above the window's lower edge. Goes back to screen().
    void keepFree(int rows);

    /// What is drawn while the scope lives is drawn in a place of its own, or only within a rectangle.
    class Scope;
    [[nodiscard]] Scope place(const Place& place);
    [[nodiscard]] Scope clip(const Vec2& corner, const Vec2& size);

    void clear(const Paint& paint);  ///< all of the window; of a gradient, in the units now drawn in
    /// From the corner of the least x and y.
    void rect(const Vec2& corner, const Vec2& size, const Brush& brush, double radius = 0);
    void box(const Vec2& center, const Vec2& halfSize, const Brush& brush, double radius = 0);
    void circle(const Vec2& center, double radius, const Brush& brush);
    void ellipse(const Vec2& center, const Vec2& radii, const Brush& brush);
    /// From one angle on to another, from +x towards +y [rad].
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
        Affine view;      ///< to pixels, without the places drawn in
        Affine toPixels;  ///< with them
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
