// SPDX-License-Identifier: MIT
#include <games/shell/desktop/frame_times.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

namespace plumb::games {
namespace {

constexpr std::size_t aSecond = 60;

std::vector<double> last(const std::vector<double>& all, std::size_t count) {
    return {all.end() - static_cast<std::ptrdiff_t>(std::min(all.size(), count)), all.end()};
}

double rateOf(const std::vector<double>& intervals) {
    const double sum = std::accumulate(intervals.begin(), intervals.end(), 0.0);
    return sum > 0 ? static_cast<double>(intervals.size()) / sum : 0;
}

nlohmann::ordered_json inMilliseconds(const std::vector<double>& seconds) {
    const Durations d = durationsOf(seconds);
    const auto rounded = [](double s) { return std::round(s * 1e6) / 1e3; };
    return {{"median", rounded(d.median)}, {"p99", rounded(d.high)}, {"max", rounded(d.max)}};
}

}  // namespace

Durations durationsOf(std::vector<double> seconds) {
    if (seconds.empty()) return {};
    std::sort(seconds.begin(), seconds.end());
    const std::size_t last = seconds.size() - 1;
    return {seconds[last / 2], seconds[last * 99 / 100], seconds[last]};
}

FooterLine FrameTimes::figures() const {
    const Durations tick = durationsOf(last(ticks_, aSecond)), frame = durationsOf(last(frames_, aSecond));
    return {
        fmt::format("{:.0f} frames/s", rateOf(last(intervals_, aSecond))),
        fmt::format("tick {:.2f} ms, at most {:.2f}", tick.median * 1e3, tick.max * 1e3),
        fmt::format("frame {:.2f} ms, at most {:.2f}", frame.median * 1e3, frame.max * 1e3),
    };
}

std::string FrameTimes::summary() const {
    nlohmann::ordered_json line;
    line["frames"] = frames_.size();
    line["fps"] = std::round(rateOf(intervals_) * 100) / 100;
    line["tick_ms"] = inMilliseconds(ticks_);
    line["frame_ms"] = inMilliseconds(frames_);
    line["interval_ms"] = inMilliseconds(intervals_);
    return line.dump();
}

}  // namespace plumb::games
