// SPDX-License-Identifier: MIT
// What would stop a body on its way, with other kinematic bodies already where the coming step takes them?
#pragma once
#include <optional>
#include <vector>

#include <plumb/movers/detail/face_span.h>
#include <plumb/movers/detail/one_way.h>
#include <plumb/movers/move_and_slide.h>

namespace plumb::detail {

/// A body that moves of itself, and a point's way back in time: from where the step takes the point, to where it is.
struct MovingThing {
    BodyId body;
    Transform back;
};

/// Where a step of dt takes a kinematic body; of a dynamic one it is a guess, and never downward. In a world that
/// wraps, of the body's places the one nearest to near.
MovingThing movingThing(const World& world, BodyId body, double dt, const Vec2& up, const Vec2& near);

/// How far a way is free, a skin short of what stops it.
struct FreeWay {
    double length = 0;
    std::optional<CastHit> hit = std::nullopt;
};

struct Overlapped {
    CastHit hit;  ///< the normal is the way out
    double depth = 0;
};

/// All that is within a distance of a shape.
Shape grown(Shape shape, double by);

class SlideProbe {
public:
    SlideProbe(const World& world, BodyId body, const SlideSettings& settings, double dt);

    /// Looks for what moves within this distance of the body; what it stands on is one of them. still:
    /// what stays where it is for now.
    void findMoving(double within, const std::optional<BodyId>& floor, std::span<const BodyId> still);
    const std::vector<MovingThing>& moving() const { return moving_; }
    const MovingThing* find(BodyId body) const;  ///< nullptr when it does not move
    /// Goes through this one, if any, as if it were not there.
    void pass(const std::optional<BodyId>& body) { passed_ = body; }
    void passFloor(const OneWayFloor& floor);
    /// Those on which the body stands, or which are flush with those on a way.
    void passFloorsUnder(const Vec2& at, const Vec2& way);
    const std::vector<OneWayFloor>& passedFloors() const { return passedFloors_; }

    const World& world() const { return world_; }
    /// Tile maps of which anything was in the way of anything so far.
    const std::vector<ShapeId>& mapsMet() const { return maps_; }
    void meetMap(const ShapeId& map) const;
    /// Where the step takes it; in a world that wraps, of its places the one nearest to near.
    Transform poseOfMap(const ShapeId& shape, const TileMap& map, const Vec2& near) const;
    /// visit(shape, pose) of each of the body's, grown by so many skins.
    template <class Visit>
    void forEachShape(const Vec2& at, double skins, Visit&& visit) const {
        for (const Own& own : own_) visit(grown(own.shape, skins * settings_.skin), poseAt(at));
    }

    /// The body is where from says, and shifted. Only what has a normal that rises by leastRise is met [-].
    FreeWay freeWay(const Vec2& from, const Vec2& shift, double leastRise = -2) const;
    /// The same of one that moves, as seen from it: the body goes from one place before the step to one after it.
    FreeWay freeWayAgainst(const MovingThing& thing, const Vec2& from, const Vec2& to) const;
    /// What is static or kinematic and overlaps the body.
    std::vector<Overlapped> overlaps(const Vec2& at) const;
    bool isInPassedFloor(const Vec2& at) const;
    /// Of the one of the body's shapes that is farthest out that way.
    FaceSpan faceSpanAt(const Vec2& at, const Vec2& way, const Vec2& line) const;

private:
    struct Own {
        Shape shape;
        Shape inflated;  ///< grown by a skin
        Shape around;    ///< by a hair more, so that it touches all that a cast of inflated begins at
        Filter filter;
    };

    Transform poseAt(const Vec2& position) const { return {position, rotation_}; }
    /// Everything that a shape of the body meets, moving things as they will be; visit(hit).
    template <class Visit>
    void meetAll(const Shape& shape, const Filter& filter, const Vec2& from, const Vec2& shift, Visit&& visit) const;
    template <class Meet>
    FreeWay freeWayBy(const Vec2& from, const Vec2& shift, double leastRise, Meet&& meet) const;
    bool isSolid(const CastHit& hit) const;
    bool isPassed(const OneWayFloor& floor) const;
    bool isSame(const CastHit& a, const CastHit& b) const;
    std::optional<Vec2> wallOf(const std::vector<CastHit>& here, const CastHit& met, const Vec2& shift) const;
    bool isIn(const Own& own, const Vec2& at, const CastHit& met) const;
    double depthOf(const Own& own, const Vec2& at, const CastHit& hit) const;

    const World& world_;
    BodyId body_;
    const SlideSettings& settings_;
    double dt_;
    Rot rotation_;
    std::vector<Own> own_;
    std::vector<MovingThing> moving_;
    std::vector<OneWayFloor> passedFloors_;
    mutable std::vector<ShapeId> maps_;  ///< for the record only: no answer depends on it
    std::optional<BodyId> passed_ = std::nullopt;
};

}  // namespace plumb::detail
