// SPDX-License-Identifier: MIT
// Which states of a run does the page play back, and how finely?
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/report/packed_numbers.h>

namespace plumb::compare {

/// Every stride-th tick and the last one, each number in width bytes.
struct PlaybackFormat {
    NumberWidth width = NumberWidth::Float64;
    std::size_t stride = 1;
};

/// The scene's bodies, by index, that move in this engine: all but the static ones; of the closed form, those it is
/// about.
std::vector<std::size_t> playedBodies(const Scene& scene, Role role);

/// How many ticks of a run are played before thinning; the closed form only as far as it holds.
std::size_t playedTicks(const Scene& scene, const Observation& run);

/// The ticks kept out of `ticks`: every stride-th and the last.
std::vector<std::size_t> keptTicks(std::size_t ticks, std::size_t stride);

/// The size of a scene's playback, all engines together [byte].
std::size_t playbackBytes(const SceneResult& result, const PlaybackFormat& format);

/// A format for each scene, in their order, so that all together stay within budget [byte]: small scenes keep every
/// tick and every digit, and the large ones share what they leave. First the digits go, then ticks.
std::vector<PlaybackFormat> fitPlayback(const std::vector<SceneResult>& results, std::size_t budget);

/// x, y [m] and angle [rad] of every played body at every kept tick, tick by tick, as text.
std::string packPlayback(const Scene& scene, const Observation& run, const PlaybackFormat& format);

}  // namespace plumb::compare
