// SPDX-License-Identifier: MIT
#include <compare/check/verdict.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::compare {
namespace {

constexpr double visible = 1e-3;    // an error nobody sees in a game [m]
constexpr double rounding = 1e-12;  // relative to the scene's size: thousands of roundings of a double [-]

class Judge {
public:
    Judge(const SceneResult& measured, const std::vector<Engine>& engines) : measured_(measured), engines_(engines) {
        for (const EngineResult& run : measured.engines)
            if (run.observation.role == Role::Subject) subject_ = run.observation.engine;
    }

    std::vector<Outcome> operator()(const ExactCheck& check) const {
        const EngineResult* subject = judged(subject_);
        if (!subject) return {};
        const std::optional<double> error = metricOf(*subject, "error_max");
        std::vector<Outcome> outcomes{atMost("exact", subject, "error_max", error, check.limit, check.reason)};
        if (!error) outcomes.front().missing = whyNoTruth();
        if (const std::optional<double> best = bestPeerError()) {
            const std::string reason = fmt::format("no worse than the best peer ({:.3g} m), or 1 mm", *best);
            outcomes.push_back(atMost("exact", subject, "error_max", error, std::max(visible, *best), reason));
        }
        return outcomes;
    }

    std::vector<Outcome> operator()(const AgreeCheck& check) const {
        const EngineResult* subject = judged(subject_);
        if (!subject) return {};
        std::vector<Outcome> outcomes;
        for (const EngineResult& run : measured_.engines) {
            if (run.observation.role != Role::Peer || !run.observation.unsupported.empty()) continue;
            const std::optional<double> apart =
                divergenceUntil(measured_.scene, run.observation, subject->observation, check.until);
            outcomes.push_back(atMost("agree", &run, "divergence_max", apart, check.tolerance, check.reason));
        }
        return outcomes;
    }

    std::vector<Outcome> operator()(const InvariantCheck& check) const {
        std::vector<Outcome> outcomes;
        if (std::ranges::find(measured_.unjudged, check.metric) != measured_.unjudged.end()) return outcomes;
        for (const std::string& engine : bound(check.engines))
            if (const EngineResult* run = judged(engine))
                outcomes.push_back(
                    atMost("invariant", run, check.metric, metricOf(*run, check.metric), check.limit, check.reason));
        return outcomes;
    }

    std::vector<Outcome> operator()(const OrderCheck& check) const {
        std::vector<Outcome> outcomes;
        for (const std::string& engine : bound(check.engines))
            if (const EngineResult* run = judged(engine)) outcomes.push_back(orderOf(*run, check));
        return outcomes;
    }

private:
    /// The engines that a check binds: the subject where it names none.
    std::vector<std::string> bound(const std::vector<std::string>& engines) const {
        return engines.empty() ? std::vector{subject_} : engines;
    }

    /// The run of an engine that a check can bind: see runScene.
    const EngineResult* judged(std::string_view engine) const {
        for (const EngineResult& run : measured_.engines)
            if (run.observation.engine == engine && (run.observation.unsupported.empty() || engine == subject_))
                return &run;
        return nullptr;
    }

    static std::optional<double> metricOf(const EngineResult& run, const std::string& metric) {
        const auto found = run.measured.metrics.find(metric);
        return found == run.measured.metrics.end() ? std::nullopt : found->second;
    }

    static Outcome atMost(const std::string& check, const EngineResult* run, const std::string& metric,
                          std::optional<double> value, double limit, const std::string& reason) {
        // Also false for a value that is not a number.
        const bool pass = value && *value <= limit;
        return {check, run->observation.engine, metric, value, limit, pass, reason};
    }

    /// Why the closed form could not be worked out; empty where it was.
    std::string whyNoTruth() const {
        for (const EngineResult& run : measured_.engines)
            if (run.observation.role == Role::Truth) return run.observation.unsupported;
        return {};
    }

    std::optional<double> bestPeerError() const {
        std::optional<double> best;
        for (const EngineResult& run : measured_.engines) {
            if (run.observation.role != Role::Peer) continue;
            const std::optional<double> error = metricOf(run, "error_max");
            if (error && std::isfinite(*error)) best = std::min(best.value_or(*error), *error);
        }
        return best;
    }

    Outcome orderOf(const EngineResult& run, const OrderCheck& check) const {
        Outcome outcome{"order", run.observation.engine, "order", {}, check.order, false, check.reason};
        std::vector<double> errors;
        for (const double part : {1.0, 0.5, 0.25}) {
            const std::optional<double> error = part == 1 ? metricOf(run, "error_max") : errorAt(run, part);
            if (!error) {
                outcome.missing = whyNoTruth();
                return outcome;
            }
            errors.push_back(*error);
        }
        if (!std::all_of(errors.begin(), errors.end(), [](double error) { return std::isfinite(error); }))
            return outcome;
        outcome.value = observedOrder(errors, rounding * sizeOf(run.observation));
        outcome.pass = !outcome.value || *outcome.value >= check.order;
        return outcome;
    }

    /// error_max of the scene, run again with a part of its step.
    std::optional<double> errorAt(const EngineResult& run, double part) const {
        Scene scene = measured_.scene;
        scene.dt *= part;
        std::optional<Observation> again, truth;
        for (const Engine& engine : engines_) {
            if (engine.name == run.observation.engine) again = observe(scene, engine);
            if (engine.role == Role::Truth) truth = observe(scene, engine);
        }
        if (!again || !truth) return {};
        return measure(scene, *again, &*truth, nullptr).metrics.at("error_max");
    }

    /// The largest coordinate that a body has in the run, at least 1 [m].
    static double sizeOf(const Observation& run) {
        double size = 1;
        for (const std::vector<BodyState>& row : run.states)
            for (const BodyState& state : row) size = std::max(size, state.position.cwiseAbs().maxCoeff());
        return size;
    }

    std::string subject_;  // empty where it was not run
    const SceneResult& measured_;
    const std::vector<Engine>& engines_;
};

/// The closed form gives the angle that the probe watches.
bool isByClosedForm(const Scene& scene, const Probe& probe) {
    const auto* angle = std::get_if<AngleProbe>(&probe.quantity);
    if (!angle || !scene.closedForm) return false;
    return std::ranges::any_of(scene.closedForm->bodies, [&](const BodyMotion& motion) {
        return std::visit([&](const auto& each) { return each.body == angle->body; }, motion);
    });
}

}  // namespace

std::optional<double> observedOrder(std::span<const double> errors, double floor) {
    std::optional<double> order;
    for (std::size_t i = 0; i + 1 < errors.size() && errors[i] > floor; ++i) {
        const double ratio = std::log2(errors[i] / std::max(errors[i + 1], floor));
        order = std::min(order.value_or(ratio), ratio);
    }
    return order;
}

std::vector<std::string> metricsOfItsNumbers(const Scene& scene, const Observation& truth) {
    std::vector<std::string> metrics;
    for (const Check& check : scene.checks) {
        const auto* invariant = std::get_if<InvariantCheck>(&check);
        if (!invariant) continue;
        const auto probe =
            std::ranges::find(scene.probes, invariant->metric, [](const Probe& each) { return "probe." + each.name; });
        const bool follows = truth.unsupported.empty() && probe != scene.probes.end() && isByClosedForm(scene, *probe);
        if (probe != scene.probes.end() && !follows) metrics.push_back(invariant->metric);
    }
    return metrics;
}

std::vector<Outcome> judge(const SceneResult& measured, const std::vector<Engine>& engines) {
    std::vector<Outcome> outcomes;
    for (const Check& check : measured.scene.checks)
        for (Outcome& outcome : std::visit(Judge(measured, engines), check)) outcomes.push_back(std::move(outcome));
    return outcomes;
}

}  // namespace plumb::compare
