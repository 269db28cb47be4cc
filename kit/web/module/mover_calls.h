// SPDX-License-Identifier: MIT
// Which functions of movers, paths and clocks does JavaScript have? Movers live in a world.
#pragma once
#include <plumb/math/random.h>
#include <plumb/movers/arcade_maze.h>
#include <plumb/movers/grid_choice.h>
#include <plumb/movers/move_and_collide.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/stepping/interpolate.h>
#include <web/module/call.h>

namespace plumb::web {

template <class Mover, class... A>
std::size_t addMover(WorldHost& host, const A&... arguments) {
    return host.of<Mover>().put(Mover(arguments...));
}

void listGridCalls(auto&& list) {
    using Grid = Held<GridMover>;
    list("GridMover", "new", "world, def?",
         fn<[](WorldHost& host, const GridMoverDef& def) { return addMover<GridMover>(host, def); }>);
    list("GridMover", "free", "", fn<&Grid::free>);
    list("GridMover", "want", "direction", fn<[](Grid m, Direction direction) { m->want(direction); }>);
    list("GridMover", "wantNothing", "", fn<[](Grid m) { m->wantNothing(); }>);
    list("GridMover", "halt", "", fn<[](Grid m) { m->halt(); }>);
    list("GridMover", "reverseOnEntry", "", fn<[](Grid m) { m->reverseOnEntry(); }>);
    list("GridMover", "pauseFrames", "frames", fn<[](Grid m, int frames) { m->pauseFrames(frames); }>);
    list("GridMover", "pause", "time", fn<[](Grid m, double time) { m->pause(time); }>);
    list("GridMover", "setPass", "pass", fn<[](Grid m, const GridPass& pass) { m->setPass(pass); }>);
    list("GridMover", "setCornering", "cornering",
         fn<[](Grid m, const Cornering& cornering) { m->setCornering(cornering); }>);
    list("GridMover", "move", "map, speed, dt",
         fn<[](Grid m, ShapeId map, double speed, double dt) { return m->move(m.world().tiles(map), speed, dt); }>);
    list("GridMover", "moveFrame", "map, speed",
         fn<[](Grid m, ShapeId map, SpeedPattern speed) { return m->moveFrame(m.world().tiles(map), speed); }>);
    list("GridMover", "cell", "", fn<[](Grid m) { return m->cell(); }>);
    list("GridMover", "heading", "", fn<[](Grid m) { return m->heading(); }>);
    list("GridMover", "wanted", "", fn<[](Grid m) { return m->wanted(); }>);
    list("GridMover", "stopped", "", fn<[](Grid m) { return m->stopped(); }>);
    list("GridMover", "offset", "", fn<[](Grid m) { return m->offset(); }>);
    list("GridMover", "position", "map", fn<[](Grid m, ShapeId map) { return m->position(m.world().tiles(map)); }>);
    list("GridMover", "def", "", fn<[](Grid m) { return m->def(); }>);
    list("", "isOpen", "world, map, cell, direction, pass?",
         fn<[](const World& w, ShapeId map, Cell cell, Direction direction, const GridPass& pass) {
             return isOpen(w.tiles(map), cell, direction, pass);
         }>);
    list("", "nextDirection", "world, map, crossing, target",
         fn<[](const World& w, ShapeId map, const GridCrossing& crossing, Cell target) {
             return nextDirection(w.tiles(map), crossing, target);
         }>);
    list("", "firstOpenClockwise", "world, map, crossing, wanted",
         fn<[](const World& w, ShapeId map, const GridCrossing& crossing, Direction wanted) {
             return firstOpenClockwise(w.tiles(map), crossing, wanted);
         }>);
    list("", "speedPattern", "percent", fn<&speedPattern>);
    list("", "arcadeMaze", "", fn<&arcadeMaze>);
    list("", "arcadeSpeeds", "level", fn<&arcadeSpeeds>);
    list("", "arcadeFright", "level", fn<&arcadeFright>);
    list("", "arcadeWaves", "level", fn<&arcadeWaves>);
    list("", "arcadeHouse", "level", fn<&arcadeHouse>);
    list("", "arcadeFruit", "level", fn<&arcadeFruit>);
    list("", "arcadeHasteDots", "level", fn<&arcadeHasteDots>);
    list("", "modeAt", "waves, time", fn<&modeAt>);
    list("", "hunterTarget", "hunter, context, maze", fn<&hunterTarget>);
    list("", "hunterPercent", "speeds, slow, frightened, haste = 0", fn<&hunterPercent>);
}

void listPlatformCalls(auto&& list) {
    using Hero = Held<PlatformMover>;
    list("PlatformMover", "new", "world, body, profile?",
         fn<[](WorldHost& host, BodyId body, const std::optional<PlatformProfile>& profile) {
             return addMover<PlatformMover>(host, body, profile ? *profile : modernProfile());
         }>);
    list("PlatformMover", "free", "", fn<&Hero::free>);
    list("PlatformMover", "step", "input, dt, later?",
         fn<[](Hero m, const PlatformInput& input, double dt, const std::optional<std::vector<BodyId>>& later) {
             return m->step(m.world(), input, dt, later ? *later : std::vector<BodyId>{});
         }>);
    list("PlatformMover", "body", "", fn<[](Hero m) { return m->body(); }>);
    list("PlatformMover", "profile", "", fn<[](Hero m) { return m->profile(); }>);
    list("PlatformMover", "setProfile", "profile",
         fn<[](Hero m, const PlatformProfile& profile) { m->setProfile(profile); }>);
    list("PlatformMover", "slide", "", fn<[](Hero m) { return m->slide(); }>);
    list("PlatformMover", "hasJumped", "", fn<[](Hero m) { return m->hasJumped(); }>);
    list("PlatformMover", "setVelocity", "velocity",
         fn<[](Hero m, const Vec2& velocity) { m->setVelocity(velocity); }>);
    list("PlatformMover", "launch", "velocity", fn<[](Hero m, const Vec2& velocity) { m->launch(velocity); }>);
    list("", "modernProfile", "feel?", fn<&modernProfile>);
    list("", "profile1985", "", fn<&profile1985>);
    list("", "jumpHeight", "band, held = Infinity", fn<&jumpHeight>);
    list("", "testMove", "world, body, displacement, skin = 0.001", fn<&testMove>);
    list("", "moveAndCollide", "world, body, displacement, dt, skin = 0.001", fn<&moveAndCollide>);
    list("", "moveAndSlide", "world, body, motion, settings?, last?", fn<&moveAndSlide>);
}

void listPathCalls(auto&& list) {
    using Path = Held<PathMover>;
    list("PathMover", "new", "world, def",
         fn<[](WorldHost& host, const PathMoverDef& def) { return addMover<PathMover>(host, def); }>);
    list("PathMover", "free", "", fn<&Path::free>);
    list("PathMover", "at", "time", fn<[](Path m, double time) { return m->at(time); }>);
    list("PathMover", "atTick", "tick, dt",
         fn<[](Path m, double tick, double dt) { return m->atTick(static_cast<std::int64_t>(tick), dt); }>);
    list("PathMover", "poseAfter", "tick, dt, angle = 0", fn<[](Path m, double tick, double dt, double angle) {
             return m->poseAfter(static_cast<std::int64_t>(tick), dt, angle);
         }>);
    list("PathMover", "period", "", fn<[](Path m) { return m->period(); }>);
    list("", "pathLength", "path", fn<[](const MotionPath& path) { return path.length(); }>);
    list("", "pathPlaceAt", "path, along", fn<[](const MotionPath& path, double along) { return path.at(along); }>);
}

void listClockCalls(auto&& list) {
    list("FixedClock", "new", "settings?", fn<[](const ClockSettings& settings) { return FixedClock(settings); }>);
    list("FixedClock", "advance", "elapsed", fn<&FixedClock::advance>);
    list("FixedClock", "pause", "", fn<&FixedClock::pause>);
    list("FixedClock", "resume", "", fn<&FixedClock::resume>);
    list("FixedClock", "paused", "", fn<&FixedClock::paused>);
    list("FixedClock", "singleStep", "", fn<&FixedClock::singleStep>);
    list("FixedClock", "setTimeScale", "timeScale", fn<&FixedClock::setTimeScale>);
    list("FixedClock", "interval", "", fn<&FixedClock::interval>);
    list("FixedClock", "timeScale", "", fn<&FixedClock::timeScale>);
    list("FixedClock", "tick", "", fn<&FixedClock::tick>);
    list("FixedClock", "time", "", fn<&FixedClock::time>);
    list("Random", "new", "seed", fn<[](std::uint64_t seed) { return Random(seed); }>);
    list("Random", "bits", "", fn<&Random::bits>);
    list("Random", "uniform", "low, high", fn<&Random::uniform>);
    list("Random", "integer", "low, high", fn<&Random::integer>);
    list("", "shortestTurn", "from, to", fn<&shortestTurn>);
    list("", "interpolateAngle", "from, to, fraction", fn<&interpolateAngle>);
    list("", "interpolatePose", "from, to, fraction",
         fn<[](const Transform& from, const Transform& to, double fraction) {
             return interpolate(from, to, fraction);
         }>);
}

}  // namespace plumb::web
