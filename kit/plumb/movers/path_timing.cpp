// SPDX-License-Identifier: MIT
#include <plumb/movers/path_timing.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>

namespace plumb {

namespace {

void requireSound(double length, const PathTiming& timing) {
    requirePositive(length, "length");
    requirePositive(timing.speed, "PathTiming.speed");
    if (timing.easing == Easing::Acceleration) requirePositive(timing.acceleration, "PathTiming.acceleration");
}

/// The duration of the acceleration.
double accelerationTime(double length, const PathTiming& timing) {
    return std::min(timing.speed / timing.acceleration, std::sqrt(length / timing.acceleration));
}

double totalTime(double length, const PathTiming& timing) {
    switch (timing.easing) {
        case Easing::None: break;
        case Easing::SmoothStep: return 1.5 * length / timing.speed;
        case Easing::Acceleration: {
            const double rise = accelerationTime(length, timing);
            return rise + length / (timing.acceleration * rise);
        }
    }
    return length / timing.speed;
}

/// In the first half of the time.
Progress early(double length, const PathTiming& timing, double time, double total) {
    switch (timing.easing) {
        case Easing::None: break;
        case Easing::SmoothStep: {
            const double part = time / total;
            return {length * part * part * (3 - 2 * part), 6 * length / total * part * (1 - part)};
        }
        case Easing::Acceleration: {
            const double rise = accelerationTime(length, timing), a = timing.acceleration;
            if (time < rise) return {0.5 * a * time * time, a * time};
            return {a * rise * (time - 0.5 * rise), a * rise};
        }
    }
    return {timing.speed * time, timing.speed};
}

}  // namespace

double timeOf(double length, const PathTiming& timing) {
    requireSound(length, timing);
    const double time = totalTime(length, timing);
    requirePositive(time, "PathTiming: time");
    return time;
}

Progress progressAt(double length, const PathTiming& timing, double time) {
    const double total = timeOf(length, timing);
    requireFinite(time, "progressAt: time");
    time = std::clamp(time, 0.0, total);
    if (2 * time <= total) return early(length, timing, time, total);
    // The second half is the first one mirrored in time: so both ends are reached exactly.
    const Progress mirrored = early(length, timing, total - time, total);
    return {length - mirrored.along, mirrored.speed};
}

}  // namespace plumb
