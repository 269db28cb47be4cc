// SPDX-License-Identifier: MIT
#include <compare/report/playback.h>
#include <compare/view/scene_view.h>

#include <vector>

#include "catch.h"
#include "compare/scripted.h"
#include "unpacked.h"

namespace plumb::compare {
namespace {

/// Discs on a static floor that move along x with the time, in one engine.
SceneResult discs(int count, int steps) {
    Scene scene = oneDisc();
    scene.closedForm.reset();
    const SceneBody disc = scene.bodies[0];
    SceneBody floor;
    floor.name = "floor";
    floor.def.type = BodyType::Static;
    floor.def.shapes = {box({10, 0.5})};
    scene.bodies = {floor};
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(disc);
        scene.bodies.back().name = "disc_" + std::to_string(i);
    }
    scene.dt = 0.125;
    scene.duration = steps * scene.dt;
    SceneResult result;
    result.scene = scene;
    Observation run;
    run.role = Role::Subject;
    run.dt = scene.dt;
    for (int tick = 0; tick <= steps; ++tick) {
        std::vector<BodyState> states(scene.bodies.size(), at(tick * scene.dt, 0));
        states[0] = at(0, 0);
        run.states.push_back(states);
    }
    result.engines = {{run, {}}};
    return result;
}

std::size_t total(const std::vector<SceneResult>& results, const std::vector<PlaybackFormat>& formats) {
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < results.size(); ++i) numbers += playbackNumbers(results[i], formats[i].stride);
    return numbers;
}

}  // namespace

TEST_CASE("the kept ticks begin with 0, end with the last, and are a stride apart", "[compare][report]") {
    CHECK(keptTicks(5, 1) == std::vector<std::size_t>{0, 1, 2, 3, 4});
    CHECK(keptTicks(5, 2) == std::vector<std::size_t>{0, 2, 4});
    CHECK(keptTicks(6, 2) == std::vector<std::size_t>{0, 2, 4, 5});
    CHECK(keptTicks(6, 100) == std::vector<std::size_t>{0, 5});
    CHECK(keptTicks(1, 3) == std::vector<std::size_t>{0});
    CHECK(keptTicks(0, 1).empty());
}

TEST_CASE("two discs over ten steps are 66 numbers, the static floor is not played", "[compare][report]") {
    const SceneResult result = discs(2, 10);
    CHECK(movingBodies(result.scene, Role::Subject) == std::vector<std::size_t>{1, 2});
    CHECK(playbackNumbers(result, 1) == 2 * 11 * 3);
    CHECK(playbackNumbers(result, 4) == 2 * 4 * 3);  // ticks 0, 4, 8, 10
    PackedBlock block;
    const PackedPart part = packPlayback(result.scene, result.engines[0].observation, {4, 0.125, 0.125}, block);
    CHECK(part.count == 24);
    const UnpackedBlock read(block.text());
    for (const std::size_t disc : {0u, 12u}) {
        CHECK(read.steps(disc, 4, 0.125) == std::vector<double>{0, 0.5, 1.0, 1.25});
        CHECK(read.steps(disc + 4, 8, 0.125) == std::vector<double>(8, 0));
    }
}

TEST_CASE("scenes within the budget keep all their steps", "[compare][report]") {
    const std::vector<SceneResult> results{discs(2, 10), discs(5, 100)};
    for (const PlaybackFormat& format : fitPlayback(results, 1'000'000)) CHECK(format.stride == 1);
}

TEST_CASE("a large scene loses steps, the small ones beside it lose none", "[compare][report]") {
    const std::vector<SceneResult> results{discs(20, 1000), discs(2, 10)};
    REQUIRE(playbackNumbers(results[0], 1) == 60'060);
    const std::vector<PlaybackFormat> thin = fitPlayback(results, 25'000);
    CHECK(thin[0].stride == 3);  // 60 numbers a tick, 415 of 1,001 ticks fit
    CHECK(thin[1].stride == 1);
    CHECK(total(results, thin) <= 25'000);
}

TEST_CASE("a step is 2^-24 of the way in the engine whose bodies go the least far", "[compare][report]") {
    SceneResult result = discs(1, 24);  // 3 m
    CHECK(fitPlayback({result}, 1'000'000)[0].lengthStep == 4 * 0x1p-24);
    CHECK(fitPlayback({result}, 1'000'000)[0].angleStep == 0x1p-24);
    result.engines.push_back(result.engines[0]);
    for (std::vector<BodyState>& states : result.engines[1].observation.states) states[1].position.x() *= 1e200;
    CHECK(fitPlayback({result}, 1'000'000)[0].lengthStep == 4 * 0x1p-24);
}

TEST_CASE("with no budget at all each scene still has its first and last tick", "[compare][report]") {
    const std::vector<SceneResult> results{discs(1, 10)};
    const std::vector<PlaybackFormat> formats = fitPlayback(results, 0);
    CHECK(keptTicks(11, formats[0].stride) == std::vector<std::size_t>{0, 10});
}

TEST_CASE("the closed form plays the bodies it is about, as long as it holds", "[compare][report]") {
    Scene scene = oneDisc();
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "other";
    scene.closedForm->until = 0.3;
    Observation run;
    run.role = Role::Truth;
    run.dt = 0.1;
    run.states.resize(11);
    CHECK(movingBodies(scene, Role::Truth) == std::vector<std::size_t>{0});
    CHECK(movingBodies(scene, Role::Subject) == std::vector<std::size_t>{0, 1});
    CHECK(playedTicks(scene, run) == 4);  // 0, 0.1, 0.2 and 0.3 s, though 3 x 0.1 > 0.3 in binary
    run.role = Role::Subject;
    CHECK(playedTicks(scene, run) == 11);
}

}  // namespace plumb::compare
