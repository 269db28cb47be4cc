// SPDX-License-Identifier: MIT
// Which states of a run does the page play back, and how finely?
#pragma once
#include <cstddef>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/report/packed_numbers.h>

namespace plumb::compare {

/// How finely a scene is played: positions and angles in whole steps, every stride-th tick and the last one.
/// A step is 2^-24 of how far the bodies go. So even if differences of engines are drawn a thousand times as large,
/// they move by less than a tenth of a pixel per step; each bit less would save 8 % of the playback. An engine whose
/// bodies fly off by more than 128 times that distance is not shown there.
struct PlaybackFormat {
    std::size_t stride = 1;
    double lengthStep = 0;  ///< [m]
    double angleStep = 0;   ///< [rad]
};

/// How many ticks of a run are played before thinning; for the closed form, only as far as it holds.
std::size_t playedTicks(const Scene& scene, const Observation& run);

/// The ticks that are kept out of `ticks`: every stride-th one and the last.
std::vector<std::size_t> keptTicks(std::size_t ticks, std::size_t stride);

/// How many numbers a scene's playback has with this stride, all engines together.
std::size_t playbackNumbers(const SceneResult& result, std::size_t stride);

/// A format for each scene, in their order. All together stay within this many numbers: small scenes keep every tick,
/// and the large ones share what is left.
std::vector<PlaybackFormat> fitPlayback(const std::vector<SceneResult>& results, std::size_t budget);

/// x, y [m] and angle [rad] of every played body, relative to its start in the scene, at every kept tick. One series
/// each.
PackedPart packPlayback(const Scene& scene, const Observation& run, const PlaybackFormat& format, PackedBlock& block);

}  // namespace plumb::compare
