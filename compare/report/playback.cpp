// SPDX-License-Identifier: MIT
#include <compare/report/playback.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include <compare/engine/engine.h>

namespace plumb::compare {
namespace {

constexpr std::size_t numbersPerBody = 3;

bool isOfClosedForm(const Scene& scene, const std::string& body) {
    if (!scene.closedForm) return false;
    return std::ranges::any_of(scene.closedForm->bodies, [&](const BodyMotion& motion) {
        return std::visit([&](const auto& m) { return m.body == body; }, motion);
    });
}

std::size_t keptCount(std::size_t ticks, std::size_t stride) {
    return ticks == 0 ? 0 : (ticks - 1 + stride - 1) / stride + 1;
}

/// The finest format within the share, or the coarsest there is: first and last tick.
PlaybackFormat finestWithin(const SceneResult& result, std::size_t share) {
    PlaybackFormat format;
    if (playbackBytes(result, format) <= share) return format;
    format.width = NumberWidth::Float32;
    const auto last = static_cast<std::size_t>(std::max(1, stepCount(result.scene)));
    while (playbackBytes(result, format) > share && format.stride < last) ++format.stride;
    return format;
}

}  // namespace

std::vector<std::size_t> playedBodies(const Scene& scene, Role role) {
    std::vector<std::size_t> played;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        if (body.def.type == BodyType::Static) continue;
        if (role == Role::Truth && !isOfClosedForm(scene, body.name)) continue;
        played.push_back(i);
    }
    return played;
}

std::size_t playedTicks(const Scene& scene, const Observation& run) {
    const std::size_t ticks = run.states.size();
    if (run.role != Role::Truth || !scene.closedForm || scene.closedForm->until <= 0 || run.dt <= 0) return ticks;
    // A tick at the very end of the form's validity counts, whatever the division's last bit says.
    const double lastTick = std::floor(scene.closedForm->until / run.dt + 1e-6);
    return lastTick + 1 < static_cast<double>(ticks) ? static_cast<std::size_t>(lastTick) + 1 : ticks;
}

std::vector<std::size_t> keptTicks(std::size_t ticks, std::size_t stride) {
    std::vector<std::size_t> kept(keptCount(ticks, stride));
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = std::min(i * stride, ticks - 1);
    return kept;
}

std::size_t playbackBytes(const SceneResult& result, const PlaybackFormat& format) {
    std::size_t numbers = 0;
    for (const EngineResult& engine : result.engines) {
        const Observation& run = engine.observation;
        numbers += keptCount(playedTicks(result.scene, run), format.stride) *
                   playedBodies(result.scene, run.role).size() * numbersPerBody;
    }
    return numbers * static_cast<std::size_t>(format.width);
}

std::vector<PlaybackFormat> fitPlayback(const std::vector<SceneResult>& results, std::size_t budget) {
    std::vector<std::size_t> full(results.size());
    std::ranges::transform(results, full.begin(), [](const SceneResult& r) { return playbackBytes(r, {}); });
    std::vector<std::size_t> bySize(results.size());
    std::iota(bySize.begin(), bySize.end(), std::size_t{0});
    std::ranges::stable_sort(bySize, [&](std::size_t a, std::size_t b) { return full[a] < full[b]; });

    std::vector<PlaybackFormat> formats(results.size());
    std::size_t left = budget;
    for (std::size_t rank = 0; rank < bySize.size(); ++rank) {
        const SceneResult& result = results[bySize[rank]];
        const PlaybackFormat format = finestWithin(result, left / (bySize.size() - rank));
        left -= std::min(left, playbackBytes(result, format));
        formats[bySize[rank]] = format;
    }
    return formats;
}

std::string packPlayback(const Scene& scene, const Observation& run, const PlaybackFormat& format) {
    const std::vector<std::size_t> bodies = playedBodies(scene, run.role);
    std::vector<double> numbers;
    for (const std::size_t tick : keptTicks(playedTicks(scene, run), format.stride)) {
        for (const std::size_t body : bodies) {
            const BodyState& state = run.states[tick][body];
            numbers.insert(numbers.end(), {state.position.x(), state.position.y(), state.angle});
        }
    }
    return packNumbers(numbers, format.width);
}

}  // namespace plumb::compare
