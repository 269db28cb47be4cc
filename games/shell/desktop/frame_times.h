// SPDX-License-Identifier: MIT
// How long do ticks and frames take?
#pragma once
#include <string>
#include <vector>

#include <games/frame/footer.h>

namespace plumb::games {

struct Durations {
    double median = 0, high = 0, max = 0;  ///< high: 99 of 100 are not longer [s]
};
Durations durationsOf(std::vector<double> seconds);  ///< all 0 for an empty list

/// The times of all ticks and frames since the start.
class FrameTimes {
public:
    void addTick(double seconds) { ticks_.push_back(seconds); }
    void addFrame(double work, double sinceLast) {
        frames_.push_back(work);
        intervals_.push_back(sinceLast);
    }

    FooterLine figures() const;  ///< of the last second
    /// One line of JSON: {"frames","fps","tick_ms","frame_ms","interval_ms"}, the last three with median, p99 and max.
    std::string summary() const;

private:
    std::vector<double> ticks_, frames_, intervals_;  ///< [s]
};

}  // namespace plumb::games
