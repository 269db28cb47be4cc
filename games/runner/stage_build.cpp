// SPDX-License-Identifier: MIT
// Builds the bodies of the world from a level.
#include <algorithm>

#include <games/runner/stage.h>
#include <plumb/space/shape_def.h>

namespace plumb::games::runner {
namespace {

/// Heroes, walkers and moths do not collide with each other; the game handles their overlaps.
constexpr Filter groundFilter{.category = 1};
constexpr Filter heroFilter{.category = 2, .mask = 1};
constexpr Filter walkerFilter{.category = 4, .mask = 1};
constexpr Filter airFilter{.category = 4, .mask = 0};

ShapeDef filtered(ShapeDef shape, const Filter& filter) {
    shape.filter = filter;
    return shape;
}

/// A flat figure of eight: out to one side and back, then the same on the other side.
PathMover mothPath(const Vec2& at) {
    const auto point = [&](double x, double y) -> Vec2 { return at + Vec2(x, y); };
    return PathMover({.path = splineThrough({point(0, 0), point(1.6, 0.5), point(3, 0), point(1.6, -0.5), point(0, 0),
                                             point(-1.6, 0.5), point(-3, 0), point(-1.6, -0.5)},
                                            true),
                      .timing = {.speed = 2.4},
                      .repeat = PathRepeat::Loop});
}

}  // namespace

Stage::Stage(std::shared_ptr<const Level> level, const StageSetup& setup)
    : level_(std::move(level)), setup_(setup), feel_(feelOf(setup.profile)) {
    build(level_->tiles);
}

void Stage::beginAgain() {
    const TileMap tiles = this->tiles();
    const std::vector<Lantern> lanterns = lanterns_;
    const std::vector<Treasure> treasures = treasures_;
    build(tiles);
    lanterns_ = lanterns;
    treasures_ = treasures;
    for (const Lantern& lantern : lanterns_)
        if (lantern.lit) world_.body(hero_.mover.body()).setPose(lantern.at, 0);
}

void Stage::build(const TileMap& tiles) {
    random_ = Random(setup_.seed);
    world_ = World({.gravity = {0, -32}});
    walkers_.clear();
    moths_.clear();
    lifts_.clear();
    springs_.clear();
    crates_.clear();
    lanterns_.clear();
    treasures_.clear();
    bumps_.clear();
    events_.clear();
    finished_ = false;
    ticks_ = 0;
    const BodyId ground =
        world_.add({.type = BodyType::Static, .shapes = {filtered(plumb::tiles(tiles), groundFilter)}});
    ground_ = {ground, 0};
    for (const Platform& platform : level_->platforms) addLift(platform);
    for (const Thing& thing : level_->things) add(thing);
    hero_ = {.mover = heroMover(level_->start)};
}

PlatformMover Stage::heroMover(const Vec2& at) {
    const BodyId body =
        world_.add({.type = BodyType::Kinematic, .position = at, .shapes = {filtered(box(heroHalf), heroFilter)}});
    return PlatformMover(body, feel_.profile);
}

void Stage::add(const Thing& thing) {
    switch (thing.kind) {
        case ThingKind::Crate: return addCrate(thing.at);
        case ThingKind::Spring: return addSpring(thing.at);
        case ThingKind::Snuffer:
        case ThingKind::Burr: return addWalker(thing);
        case ThingKind::Moth: return addMoth(thing.at);
        case ThingKind::Lantern: lanterns_.push_back({thing.at}); return;
        case ThingKind::Coin:
        case ThingKind::Sun:
        case ThingKind::Oil: break;
        case ThingKind::Beacon: return;
    }
    const auto before = std::count_if(treasures_.begin(), treasures_.end(),
                                      [&](const Treasure& other) { return other.kind == thing.kind; });
    treasures_.push_back({thing.kind, thing.at, false, static_cast<int>(before)});
}

void Stage::addWalker(const Thing& thing) {
    const double shift = random_.uniform(-0.4, 0.4);
    const int direction = random_.integer(0, 1) == 0 ? -1 : 1;
    const Vec2 at = thing.at + Vec2(shift, walkerHalf.y() - 0.5 + 0.01);
    const BodyId body =
        world_.add({.type = BodyType::Kinematic, .position = at, .shapes = {filtered(box(walkerHalf), walkerFilter)}});
    walkers_.push_back({.body = body, .thorny = thing.kind == ThingKind::Burr, .direction = direction});
}

std::int64_t Stage::phaseOf(const PathMover& path) {
    return random_.integer(0, static_cast<int>(path.period() / feel_.tick));
}

void Stage::addMoth(const Vec2& at) {
    const PathMover path = mothPath(at);
    const std::int64_t phase = phaseOf(path);
    const Vec2 position = path.atTick(phase, feel_.tick).position;
    const BodyId body = world_.add(
        {.type = BodyType::Kinematic, .position = position, .shapes = {filtered(circle(mothRadius), airFilter)}});
    moths_.push_back({body, path, phase});
}

void Stage::addSpring(const Vec2& at) {
    const Vec2 foot = at - Vec2(0, 0.5);
    const BodyId body = world_.add({.type = BodyType::Static,
                                    .position = foot + Vec2(0, 0.25),
                                    .shapes = {filtered(box({0.45, 0.25}), groundFilter)}});
    springs_.push_back({ShapeId{body, 0}, foot});
}

void Stage::addCrate(const Vec2& at) {
    const Material wood{.density = 10, .friction = 0.5};
    const BodyId body = world_.add({.position = at - Vec2(0, 0.5 - crateHalf - 0.005),
                                    .shapes = {filtered(box({crateHalf, crateHalf}, wood), groundFilter)}});
    crates_.push_back({body});
}

void Stage::addLift(const Platform& platform) {
    const bool loops = platform.repeat == PathRepeat::Loop;
    const PathMover path({.path = platform.path,
                          .timing = {.speed = loops ? 5.0 : 4.0, .easing = loops ? Easing::None : Easing::SmoothStep},
                          .repeat = platform.repeat});
    const std::int64_t phase = phaseOf(path);
    ShapeDef shape = filtered(box({platform.width / 2, platformHalf}), groundFilter);
    shape.oneWay = Vec2(0, 1);
    const BodyId body = world_.add(
        {.type = BodyType::Kinematic, .position = path.atTick(phase, feel_.tick).position, .shapes = {shape}});
    lifts_.push_back({body, path, phase, platform.width});
}

}  // namespace plumb::games::runner
