// SPDX-License-Identifier: MIT
// What would stop a moving body, if other kinematic bodies were already where the coming step takes them?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <plumb/movers/slide.h>

namespace plumb::detail {

/// The direction, in the world, from which alone the hit shape or tile is solid; empty when it is solid from all sides.
std::optional<Vec2> openSideOf(const CastHit& hit);

/// nullptr when the shape was removed, or is not a tile map any more.
const TileMap* mapOf(const World& world, const ShapeId& shape);

/// A one-way shape is one floor; one-way tiles of a map form one floor if their tops join end to end, horizontally.
bool isOneFloor(const World& world, const OneWayFloor& a, const OneWayFloor& b);

/// A moving body, and the transform that takes a point fixed to it from its position after the step to its position
/// before.
struct MovingBody {
    BodyId body;
    Transform undoStep;
};

/// Where a step of dt takes a kinematic body; for a dynamic body it is an estimate, and never downward. In a world that
/// wraps, the periodic image nearest to near.
MovingBody movingBody(const World& world, BodyId body, double dt, const Vec2& up, const Vec2& near);

/// How far a path is free, up to a skin's distance from the obstacle.
struct FreePath {
    double length = 0;
    std::optional<CastHit> hit = std::nullopt;
};

struct OverlapHit {
    CastHit hit;  ///< its normal is the direction of separation
    double depth = 0;
};

/// The interval along a line of those corners of a shape's core that are farthest in one direction, to 1 mm; a single
/// value for a round shape, and for a face that is not perpendicular to the direction.
struct FaceSpan {
    double low = 0, high = 0;  ///< [m]
    double farthest = 0;       ///< in that direction, with the shape's radius [m]
};

FaceSpan faceSpan(const Shape& shape, const Transform& pose, const Vec2& direction, const Vec2& line);

/// A shape enlarged by a distance on all sides.
Shape inflatedBy(Shape shape, double by);

class SlideProbe {
public:
    SlideProbe(const World& world, BodyId body, const SlideSettings& settings, double dt);

    /// Finds the moving bodies within this distance of the body, and the floor, if it moves. still: bodies that stay
    /// where they are for now.
    void findMoving(double within, const std::optional<BodyId>& floor, std::span<const BodyId> still);
    const std::vector<MovingBody>& moving() const { return moving_; }
    const MovingBody* find(BodyId body) const;  ///< nullptr when it does not move
    /// Ignores this body, if any.
    void pass(const std::optional<BodyId>& body) { passed_ = body; }
    void passFloor(const OneWayFloor& floor);
    /// Ignores the one-way floors on which the body stands, and floors level with them along a path.
    void passFloorsUnder(const Vec2& at, const Vec2& shift);
    const std::vector<OneWayFloor>& passedFloors() const { return passedFloors_; }

    const World& world() const { return world_; }
    /// Tile maps of which a tile was hit by any cast so far.
    const std::vector<ShapeId>& hitMaps() const { return maps_; }
    void addHitMap(const ShapeId& map) const;
    /// visit(shape, pose) for each of the body's shapes, enlarged by this number of skins.
    template <class Visit>
    void forEachShape(const Vec2& at, double skins, Visit&& visit) const {
        for (const CastShape& castShape : castShapes_)
            visit(inflatedBy(castShape.shape, skins * settings_.skin), poseAt(at));
    }

    /// The body at from is moved by shift. Only obstacles whose normal has an upward component of at least leastRise
    /// are hit [-].
    FreePath freePath(const Vec2& from, const Vec2& shift, double leastRise = -2) const;
    /// The same against one moving body, in its frame: the body goes from one position before the step to one after it.
    FreePath freePathAgainst(const MovingBody& other, const Vec2& from, const Vec2& to) const;
    /// Static and kinematic bodies that overlap the body.
    std::vector<OverlapHit> overlaps(const Vec2& at) const;
    bool isInPassedFloor(const Vec2& at) const;
    /// For the shape of the body that extends farthest in that direction.
    FaceSpan faceSpanAt(const Vec2& at, const Vec2& direction, const Vec2& line) const;

private:
    struct CastShape {
        Shape shape;
        Shape inflated;  ///< enlarged by a skin
        Shape around;    ///< by slightly more: touches all that a cast of inflated starts at
        Filter filter;
    };

    Transform poseAt(const Vec2& position) const { return {position, rotation_}; }
    /// All hits of a shape of the body, with moving bodies where they will be; visit(hit).
    template <class Visit>
    void castAll(const Shape& shape, const Filter& filter, const Vec2& from, const Vec2& shift, Visit&& visit) const;
    template <class Cast>
    FreePath freePathBy(const Vec2& from, const Vec2& shift, double leastRise, Cast&& cast) const;
    bool isSolid(const CastHit& hit) const;
    bool isPassed(const OneWayFloor& floor) const;
    bool isSame(const CastHit& a, const CastHit& b) const;
    std::optional<Vec2> wallOf(const std::vector<CastHit>& here, const CastHit& met, const Vec2& shift) const;
    bool isIn(const CastShape& castShape, const Vec2& at, const CastHit& met) const;
    double depthOf(const CastShape& castShape, const Vec2& at, const CastHit& hit) const;

    const World& world_;
    BodyId body_;
    const SlideSettings& settings_;
    double dt_;
    Rot rotation_;
    std::vector<CastShape> castShapes_;
    std::vector<MovingBody> moving_;
    std::vector<OneWayFloor> passedFloors_;
    mutable std::vector<ShapeId> maps_;  ///< a record only: no result depends on it
    std::optional<BodyId> passed_ = std::nullopt;
};

/// Which hazard tiles a body touches during a tick: those within one and a half skins of the body as it moves from
/// point to point, of the maps that it met; each once, sorted by map, row and column.
std::vector<TileTouch> hazardsOn(const SlideProbe& probe, std::span<const Vec2> path);

}  // namespace plumb::detail
