// SPDX-License-Identifier: MIT
// Which numbers sum up a run?
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// Metric name to value; empty where it does not exist, infinite where a body's state was not a number.
/// Sums and extremes go over the scene's dynamic bodies and over all ticks, the start included.
///   error_max                the largest distance of a body that has a closed form from it, as long as it holds [m]
///   error_end                the same at the last tick at which the closed form holds [m]
///   divergence_max           the largest distance of a body from the same one in Plumb [m]
///   divergence_time          the first time at which that distance is over 1 cm; empty when it never is [s]
///   energy_drift             largest |E(t) - E(0)| / largest energy of the run. E is the kinetic energy, the potential
///                            one, and that of joints' springs. The largest energy is the larger of the kinetic
///                            energy's maximum and the range of the rest: so it does not depend on where height is 0
///                            [-]
///   momentum_drift           largest |P(t) - P(0)| / largest sum of |m v| [-]
///   angular_momentum_drift   largest |L(t) - L(0)| / largest sum of (m |c - o| |v| + I |w|), about o, the centre of
///                            all masses at the start [-]
///   penetration_max          the deepest overlap of two bodies that may touch [m]
///   joint_error_max          the farthest a joint that has not broken was torn, where it leaves no freedom [m]
///   settle_time              the first time from which on no point of a body is faster than 0.05 m/s [s]
///   ms_per_step              median wall time of a step [ms]
///   probe.<name>             the largest distance of a watched quantity, or of the value that the probe says counts,
///                            from what is expected, in the quantity's unit
/// Where both the drift and the largest value are 0, the relative drift is 0. Where bodies come while the scene runs
/// there are no drifts. Without a dynamic body there are no drifts and no settle_time.
using Metrics = std::map<std::string, std::optional<double>>;

inline constexpr std::array energyKinds{"kinetic", "potential", "springs", "fields"};

/// What is plotted over time; each has one value a tick, or is empty where it does not exist. NaN at a tick for which
/// the closed form gives nothing; infinite where a body's state was not a number.
struct Series {
    std::vector<double> error;       ///< largest distance of a body from the closed form [m]
    std::vector<double> divergence;  ///< largest distance of a body from the same one in Plumb [m]
    std::vector<double> energy;      ///< the sum of all kinds, potential 0 at the world's origin [J]
    std::array<std::vector<double>, energyKinds.size()> energies;  ///< of each kind; NaN where energy is infinite [J]
};

struct Measured {
    Metrics metrics;
    Series series;
};

/// Measures one run. truth is the closed form's observation, reference is Plumb's; either may be null. A run of the
/// closed form itself has no penetration, joint error, settling time or wall time.
Measured measure(const Scene& scene, const Observation& run, const Observation* truth, const Observation* reference);

/// The largest distance of a dynamic body between two runs up to a time; empty when one of them has no states.
std::optional<double> divergenceUntil(const Scene& scene, const Observation& a, const Observation& b, double until);

/// The names of all metrics that a scene has.
std::vector<std::string> metricNames(const Scene& scene);

/// "m", "s", "ms", a probe's own unit, or "" for a ratio.
std::string metricUnit(const Scene& scene, const std::string& metric);

/// The largest distance from what is expected, from probe.from to probe.until, of the values that probe.watch counts.
/// Expected is probe.expected; for an angle of a body that has a closed form at probe.from, the closed form's angle as
/// long as it holds. Infinite where a value is not a number. Empty when nothing was watched: the run ends before
/// probe.from, or the engine does not know the value.
std::optional<double> probeError(const Scene& scene, std::size_t probe, const Observation& run,
                                 const Observation* truth);

}  // namespace plumb::compare
