// SPDX-License-Identifier: MIT
#include <games/artillery/gunnery.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/ballistics/linear_drag_aim.h>
#include <plumb/ballistics/obstacle.h>
#include <plumb/kinematics/linear_drag.h>
#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr int chargeStep = 4;
constexpr double margin = 0.5;    ///< over hilltops [m]
constexpr int samples = 30;       ///< points of a path that are compared with the ground
constexpr double nearEnds = 1.5;  ///< this close to its ends, a path may be near the ground [m]
constexpr double degree = 3.14159265358979323846 / 180;

LinearDrag airOf(const FireTask& task) {
    return {.rate = dragRate, .wind = {task.wind, 0}, .gravity = {0, -gravity}};
}

/// The charge at which a shot clears all hills, without drag and with the wind as a constant push. A shot with drag
/// needs more, or a little less when the wind is behind it.
int leastCharge(const FireTask& task, const Terrain& terrain) {
    WallAim problem{.target = task.target - task.gunner, .margin = margin};
    problem.gravity = Vec2(dragRate * task.wind, -gravity);
    const double way = problem.target.x();
    for (double x = 1; x < std::abs(way) - 1; x += 1) {
        const double at = std::copysign(x, way);
        problem.walls.emplace_back(at, terrain.heightAt(task.gunner.x() + at) - task.gunner.y());
    }
    const std::optional<plumb::Shot> slowest = aimSlowestOver(problem);
    return slowest ? chargeFor(0.95 * slowest->velocity.norm()) : 0;
}

std::optional<Aim> aimAlong(const Vec2& direction, int charge, int facing) {
    const double angle = arcTangent(direction.y(), facing * direction.x()) / degree;
    const int elevation = static_cast<int>(std::lround(angle * 10));
    if (elevation < lowestAim || elevation > highestAim) return std::nullopt;
    return Aim{facing, elevation, charge};
}

/// The low arc (which = 0) or the high arc (which = 1).
std::optional<FireSolution> arc(const FireTask& task, int charge, std::size_t which) {
    const int facing = task.target.x() >= task.gunner.x() ? 1 : -1;
    LinearDragAim problem{.speed = speedOf(charge), .drag = airOf(task)};
    Vec2 direction = Vec2(facing, 1).normalized();
    double time = 0;
    for (int round = 0; round < 4; ++round) {
        problem.target = task.target - task.gunner - muzzleFrom(direction);
        const std::vector<plumb::Shot> shots = aimThroughLinearDrag(problem);
        if (shots.size() <= which) return std::nullopt;
        direction = shots[which].velocity.normalized();
        time = shots[which].time;
    }
    const std::optional<Aim> aim = aimAlong(direction, charge, facing);
    if (!aim) return std::nullopt;
    return FireSolution{*aim, time, 0};
}

double clearanceOf(const FireSolution& solution, const FireTask& task, const Terrain& terrain) {
    const Vec2 direction = directionOf(solution.aim);
    const PointMotion launch{task.gunner + muzzleFrom(direction), speedOf(solution.aim.charge) * direction};
    const DragLaw law{dragRate, {task.wind, 0}, {0, -gravity}};
    double least = 100;
    for (int i = 0; i < samples; ++i) {
        const Vec2 at = moveWithDrag(launch, law, solution.time * i / samples).position;
        const double height = at.y() - terrain.heightAt(at.x());
        const bool near = (at - launch.position).norm() < nearEnds || (at - task.target).norm() < nearEnds;
        if (height < 0 || !near) least = std::min(least, height);
    }
    return least;
}

}  // namespace

std::vector<FireSolution> fireSolutions(const FireTask& task, const Terrain& terrain) {
    std::vector<FireSolution> found;
    for (int charge = leastCharge(task, terrain); charge <= fullCharge; charge += chargeStep)
        for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
            std::optional<FireSolution> solution = arc(task, charge, which);
            if (!solution) continue;
            solution->clearance = clearanceOf(*solution, task, terrain);
            if (solution->clearance > shellRadius) found.push_back(*solution);
        }
    return found;
}

}  // namespace plumb::games::artillery
