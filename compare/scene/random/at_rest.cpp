// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/bodies.h>
#include <compare/scene/random/worlds.h>

namespace plumb::compare {
namespace {

/// Lays blocks of one kind that touch and carry each other.
class Mason {
public:
    Mason(Scene& scene, Draw& draw, const Style& style, bool awake)
        : scene_(scene), draw_(draw), style_(style), awake_(awake) {}

    /// Adds at most this many blocks, from where the last ones ended; returns how many.
    int build(int most) {
        most_ = most;
        built_ = 0;
        chooseBlock();
        switch (draw_.integer(0, 2)) {
            case 0: pyramid(draw_.integer(3, 24)); break;
            case 1: wall(); break;
            default: stacks(); break;
        }
        right_ += draw_.uniform(0.5, 3);
        return built_;
    }

    double right() const { return right_; }  ///< where the next blocks begin [m]
    double top() const { return top_; }      ///< of the highest block [m]

private:
    void chooseBlock() {
        const double radius = drawRadius(draw_, style_), flat = draw_.uniform(0.4, 1);
        Material material = drawMaterial(draw_, style_);
        material.friction = std::max(material.friction, 0.5);  // so that blocks stay where they are laid
        material.restitution = 0;
        half_ = radius * Vec2(0.7, 0.7 * flat);
        const double rounding = draw_.chance(0.25) ? 0.2 * half_.y() : 0;
        block_ = rounding > 0 ? roundedBox(half_ - Vec2::Constant(rounding), rounding, material) : box(half_, material);
    }
    void lay(double x, int row) {
        if (built_ == most_) return;
        const double y = half_.y() * (2 * row + 1);
        addItem(scene_, {.bodies = {{"block", {.position = {x, y}, .awake = awake_, .shapes = {block_}}}}}, {0, 0});
        ++built_;
        top_ = std::max(top_, y + half_.y());
    }
    void pyramid(int base) {
        for (int row = 0; row < base; ++row)
            for (int i = 0; i < base - row; ++i) lay(right_ + half_.x() * (1 + row + 2 * i), row);
        right_ += 2 * half_.x() * base;
    }
    /// Rows on top of each other; every second row is shifted by half a block.
    void wall() {
        const int columns = draw_.integer(3, 20), rows = draw_.integer(3, 14);
        for (int row = 0; row < rows; ++row)
            for (int i = 0; i < columns - row % 2; ++i) lay(right_ + half_.x() * (1 + row % 2 + 2 * i), row);
        right_ += 2 * half_.x() * columns;
    }
    void stacks() {
        const int columns = draw_.integer(2, 12), rows = draw_.integer(1, 8);
        const double apart = half_.x() * draw_.uniform(2.2, 5);
        for (int i = 0; i < columns; ++i) {
            for (int row = 0; row < rows; ++row) lay(right_ + half_.x(), row);
            right_ += apart;
        }
    }

    Scene& scene_;
    Draw& draw_;
    const Style& style_;
    bool awake_;
    int most_ = 0, built_ = 0;
    double right_ = 0, top_ = 0;
    Vec2 half_{0, 0};
    ShapeDef block_{};
};

std::vector<Item> drawShots(Draw& draw, const Style& style, int count, bool fromAbove) {
    std::vector<Item> shots;
    for (int i = 0; i < count; ++i) {
        Item shot = drawBody(draw, style);
        const double speed = draw.uniform(5, 40), rise = draw.uniform(-0.05, 0.25);
        const Vec2 way = fromAbove ? Vec2(rise, -0.5) : Vec2(1, rise);
        shot.bodies[0].def.velocity = speed * way;
        shots.push_back(std::move(shot));
    }
    return shots;
}

}  // namespace

std::string layAtRest(Scene& scene, Draw& draw, const Style& style, int count) {
    const double share = draw.uniform(0.01, 0.05);
    const int shots = std::max(1, static_cast<int>(share * count));
    const bool asleep = scene.sleeping && draw.chance(0.75), fromAbove = draw.chance(0.3);
    Mason mason(scene, draw, style, !asleep);
    for (int left = count - shots; left > 0;) left -= mason.build(left);
    const std::vector<Item> items = drawShots(draw, style, shots, fromAbove);
    const double room = 2 * widestOf(items) + 4;
    Extent extent{-room - draw.uniform(1, 10), mason.right() + 5 + room};
    const Extent starts =
        fromAbove ? Extent{0, std::max(room, mason.right())} : Extent{extent.left, extent.left + room};
    const double bottom = fromAbove ? mason.top() + 2 : draw.uniform(0.1, 2);
    const double highest = addItems(scene, items, placeOver(items, starts, bottom, draw));
    const Material ground{.friction = 0.7};
    std::vector<ShapeDef> shapes = wallsAround(extent, 0, std::max(highest, mason.top()) + headroom, ground);
    shapes.push_back(floorAt(extent, 0, ground));
    setWorld(scene, shapes);
    return std::string(asleep ? "asleep" : "at rest") + " but for a few shot at them";
}

}  // namespace plumb::compare
