// SPDX-License-Identifier: MIT
#include <compare/report/playback.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <variant>

#include <compare/view/scene_view.h>

namespace plumb::compare {
namespace {

constexpr std::size_t numbersPerBody = 3;

std::size_t keptCount(std::size_t ticks, std::size_t stride) {
    return ticks == 0 ? 0 : (ticks - 1 + stride - 1) / stride + 1;
}

/// The least stride within the share. If none is small enough, the largest: only the first and the last tick.
std::size_t strideWithin(const SceneResult& result, std::size_t share) {
    std::size_t stride = 1;
    const auto last = static_cast<std::size_t>(std::max(1, stepCount(result.scene)));
    while (playbackNumbers(result, stride) > share && stride < last) ++stride;
    return stride;
}

/// The three numbers of a body's state, relative to its start.
std::array<double, numbersPerBody> fromStart(const SceneBody& body, const BodyState& state) {
    const Vec2 way = state.position - body.def.position;
    return {way.x(), way.y(), state.angle - body.def.angle};
}

/// How far the bodies of one engine go from their start: lengths and angles. Infinite if a run blew up.
struct Excursion {
    double length = 0, angle = 0;
};

Excursion excursionOf(const Scene& scene, const Observation& run) {
    Excursion far;
    const std::vector<std::size_t> bodies = movingBodies(scene, run.role);
    for (std::size_t tick = 0; tick < playedTicks(scene, run); ++tick) {
        for (const std::size_t body : bodies) {
            const auto [x, y, angle] = fromStart(scene.bodies[body], run.states[tick][body]);
            // The numbers of a body that does not exist yet are NaN; std::max then keeps its first argument.
            far.length = std::max(std::max(far.length, std::abs(x)), std::abs(y));
            far.angle = std::max(far.angle, std::abs(angle));
        }
    }
    return far;
}

double stepFor(double size) {
    constexpr int bits = 24;
    const bool isUsual = size > 1e-9 && size < 1e9;
    return std::ldexp(1.0, (isUsual ? static_cast<int>(std::ceil(std::log2(size))) : 0) - bits);
}

/// Uses the engine whose bodies go the least far, so that an engine that blows up does not make the others coarser.
PlaybackFormat formatWithin(const SceneResult& result, std::size_t share) {
    Excursion least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const EngineResult& engine : result.engines) {
        const Observation& run = engine.observation;
        if (run.partial || !run.unsupported.empty()) continue;
        const Excursion far = excursionOf(result.scene, run);
        least = {std::min(least.length, far.length), std::min(least.angle, far.angle)};
    }
    // At least 1 rad: a body that hardly turned in one engine may have turned in another.
    return {strideWithin(result, share), stepFor(least.length), stepFor(std::max(least.angle, 1.0))};
}

}  // namespace

std::size_t playedTicks(const Scene& scene, const Observation& run) {
    const std::size_t ticks = run.states.size();
    if (run.role != Role::Truth || !scene.closedForm || scene.closedForm->until <= 0 || run.dt <= 0) return ticks;
    // The tick at the very end of the closed form's time is included, even if the division is off by rounding.
    const double lastTick = std::floor(scene.closedForm->until / run.dt + 1e-6);
    return lastTick + 1 < static_cast<double>(ticks) ? static_cast<std::size_t>(lastTick) + 1 : ticks;
}

std::vector<std::size_t> keptTicks(std::size_t ticks, std::size_t stride) {
    std::vector<std::size_t> kept(keptCount(ticks, stride));
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = std::min(i * stride, ticks - 1);
    return kept;
}

std::size_t playbackNumbers(const SceneResult& result, std::size_t stride) {
    std::size_t numbers = 0;
    for (const EngineResult& engine : result.engines) {
        const Observation& run = engine.observation;
        numbers += keptCount(playedTicks(result.scene, run), stride) * movingBodies(result.scene, run.role).size() *
                   numbersPerBody;
    }
    return numbers;
}

std::vector<PlaybackFormat> fitPlayback(const std::vector<SceneResult>& results, std::size_t budget) {
    std::vector<std::size_t> full(results.size());
    std::ranges::transform(results, full.begin(), [](const SceneResult& r) { return playbackNumbers(r, 1); });
    std::vector<std::size_t> bySize(results.size());
    std::iota(bySize.begin(), bySize.end(), std::size_t{0});
    std::ranges::stable_sort(bySize, [&](std::size_t a, std::size_t b) { return full[a] < full[b]; });

    std::vector<PlaybackFormat> formats(results.size());
    std::size_t left = budget;
    for (std::size_t rank = 0; rank < bySize.size(); ++rank) {
        const SceneResult& result = results[bySize[rank]];
        const PlaybackFormat format = formatWithin(result, left / (bySize.size() - rank));
        left -= std::min(left, playbackNumbers(result, format.stride));
        formats[bySize[rank]] = format;
    }
    return formats;
}

PackedPart packPlayback(const Scene& scene, const Observation& run, const PlaybackFormat& format, PackedBlock& block) {
    const std::vector<std::size_t> ticks = keptTicks(playedTicks(scene, run), format.stride);
    PackedPart whole = block.addSteps({}, 1);
    for (const std::size_t body : movingBodies(scene, run.role)) {
        for (std::size_t number = 0; number < numbersPerBody; ++number) {
            std::vector<double> series;
            for (const std::size_t tick : ticks)
                series.push_back(fromStart(scene.bodies[body], run.states[tick][body])[number]);
            whole.count += block.addSteps(series, number < 2 ? format.lengthStep : format.angleStep).count;
        }
    }
    return whole;
}

}  // namespace plumb::compare
