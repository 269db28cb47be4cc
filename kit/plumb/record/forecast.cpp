// SPDX-License-Identifier: MIT
#include <plumb/record/forecast.h>

#include <string>

#include <plumb/math/check.h>

namespace plumb {

namespace {

void noteHits(const World& world, BodyId body, int tick, std::vector<ForecastHit>& hits) {
    for (const ContactBegin& begin : world.contactBegins()) {
        const bool isA = begin.shapeA.body == body;
        if (!isA && !(begin.shapeB.body == body)) continue;
        hits.push_back({tick, begin.point, isA ? Vec2(-begin.normal) : begin.normal, begin.approachSpeed,
                        isA ? begin.shapeB : begin.shapeA});
    }
}

/// Steps a world that is a copy.
Forecast follow(World& world, BodyId body, int ticks, double dt) {
    Forecast forecast;
    const auto note = [&] {
        const BodyView now = world.body(body);
        forecast.poses.push_back(now.pose());
        forecast.velocities.push_back(now.velocity());
    };
    note();
    for (int tick = 1; tick <= ticks; ++tick) {
        world.step(dt);
        note();
        noteHits(world, body, tick, forecast.hits);
    }
    return forecast;
}

World copyFor(const World& world, int ticks, double dt) {
    requireNotNegative(dt, "forecast: dt");
    if (ticks < 0) refuse("forecast: ticks", std::to_string(ticks) + " is negative");
    return world;
}

}  // namespace

Forecast forecast(const World& world, BodyId body, int ticks, double dt) {
    World copy = copyFor(world, ticks, dt);
    return follow(copy, body, ticks, dt);
}

Forecast forecast(const World& world, const BodyDef& shot, int ticks, double dt) {
    World copy = copyFor(world, ticks, dt);
    const BodyId body = copy.add(shot);
    return follow(copy, body, ticks, dt);
}

}  // namespace plumb
