// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <compare/closed_form/motion.h>
#include <compare/closed_form/oracle.h>
#include <compare/scene/joint_geometry.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

constexpr double rowRounding = 1e-9;  // the time of a tick is k dt: by rounding it may be just outside the track [s]

bool isStatic(const SceneBody& body) {
    return body.def.type == BodyType::Static;
}

struct Moved {
    Vec2 place{0, 0}, velocity{0, 0};
};

/// Between two rows it is the cubic with the places and velocities of both (Hermite). The velocity at a row is that of
/// the parabola through it and its two neighbours; at an end, of the parabola through the three rows there. So a
/// parabola comes back exactly, however uneven the times are. Two rows are joined by a line.
/// Source: Overhauser, "Analytic definition of curves and surfaces by parabolic blending", 1968.
/// Order of error: 3 in the longest time between rows.
/// Test: "a parabola sampled at 9 uneven times is the closed form of projectile within 1e-9 m"
class TrackPath {
public:
    explicit TrackPath(OwnTrack track) : track_(std::move(track)) {
        const std::size_t last = track_.times.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) velocities_.push_back(velocityAtRow(i, last));
    }

    bool covers(double time) const {
        return time >= track_.times.front() - rowRounding && time <= track_.times.back() + rowRounding;
    }

    Moved at(double time) const {
        const auto next = std::upper_bound(track_.times.begin() + 1, track_.times.end() - 1, time);
        const auto b = static_cast<std::size_t>(next - track_.times.begin()), a = b - 1;
        const double h = track_.times[b] - track_.times[a];
        const double s = std::clamp((time - track_.times[a]) / h, 0.0, 1.0);
        const Vec2 way = track_.places[b] - track_.places[a], va = h * velocities_[a], vb = h * velocities_[b];
        const Vec2 square = 3 * way - 2 * va - vb, cube = va + vb - 2 * way;
        return {track_.places[a] + s * (va + s * (square + s * cube)), (va + s * (2 * square + 3 * s * cube)) / h};
    }

private:
    double spanFrom(std::size_t row) const { return track_.times[row + 1] - track_.times[row]; }
    Vec2 meanFrom(std::size_t row) const { return (track_.places[row + 1] - track_.places[row]) / spanFrom(row); }

    Vec2 velocityAtRow(std::size_t row, std::size_t last) const {
        if (last == 1) return meanFrom(0);
        const std::size_t middle = std::clamp(row, std::size_t{1}, last - 1);
        const double before = spanFrom(middle - 1), after = spanFrom(middle);
        const Vec2 first = meanFrom(middle - 1), second = meanFrom(middle);
        const Vec2 turn = (second - first) / (before + after);  // half of the parabola's acceleration
        if (row < middle) return first - before * turn;
        if (row > middle) return second + after * turn;
        return first + before * turn;
    }

    OwnTrack track_;
    std::vector<Vec2> velocities_{};
};

/// Its closed form with numbers; none where no formula is known.
std::optional<ClosedForm> formOf(const Scene& scene) {
    try {
        return scene.closedForm ? std::optional(workedOut(scene)) : std::nullopt;
    } catch (const Unsupported&) {
        return {};
    }
}

/// A track has no angle. It is that of the start as long as the closed form says that the body does not turn; else it
/// is not known.
class OwnTrackSimulation : public Simulation {
public:
    OwnTrackSimulation(const Scene& scene, const OwnTrack& track, std::size_t body)
        : scene_(scene), path_(track), body_(body) {
        scene_.closedForm = formOf(scene);
    }

    // Time is computed from the number of steps: a sum of steps would drift by rounding.
    void step(double dt) override { time_ = dt * ++steps_; }
    std::vector<BodyState> states() const override {
        std::vector<BodyState> states(scene_.bodies.size(), unknownState());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const BodyDef& def = scene_.bodies[i].def;
            if (isStatic(scene_.bodies[i])) states[i] = {def.position, def.angle, {0, 0}, 0};
        }
        if (!path_.covers(time_)) return states;
        BodyState& own = states[body_];
        const Moved moved = path_.at(time_);
        own.position = moved.place;
        own.velocity = moved.velocity;
        const BodyState formula = closedFormStates(scene_, time_)[body_];
        if (formula.angle == scene_.bodies[body_].def.angle && formula.angularVelocity == 0) {
            own.angle = formula.angle;
            own.angularVelocity = 0;
        }
        return states;
    }
    std::vector<double> probeValues() const override {
        return std::vector<double>(scene_.probes.size(), std::numeric_limits<double>::quiet_NaN());
    }

private:
    Scene scene_;
    TrackPath path_;
    std::size_t body_;
    int steps_ = 0;
    double time_ = 0;
};

std::size_t bodyOf(const OwnTrack& track, const Scene& scene) {
    const std::string field = track.file + ": body";
    if (track.body.empty()) {
        const auto isDynamic = [](const SceneBody& body) { return body.def.type == BodyType::Dynamic; };
        const auto first = std::ranges::find_if(scene.bodies, isDynamic);
        if (first == scene.bodies.end()) refuse(field, "the scene has no dynamic body, wanted a scene with one");
        return static_cast<std::size_t>(first - scene.bodies.begin());
    }
    std::vector<SceneBody> moving = scene.bodies;
    std::erase_if(moving, isStatic);
    requireKnown(track.body, namesOf(moving), field, "a body that moves");
    return bodyIndex(scene, track.body);
}

/// A run in which the body has no place at any step would seem to have no error.
void requireSteps(const OwnTrack& track, const Scene& scene) {
    const double from = track.times.front(), to = track.times.back();
    const double first = std::max(0.0, std::ceil((from - rowRounding) / scene.dt));
    if (first * scene.dt <= to + rowRounding && first <= stepCount(scene)) return;
    refuse(track.file, "no step of the scene, which runs for " + toText(scene.duration) +
                           " s, is within the rows, from " + toText(from) + " to " + toText(to) + " s");
}

std::vector<Setting> trackSettings(const OwnTrack& track) {
    if (track.times.empty()) return {};
    return {{"file", track.file},
            {"rows", std::to_string(track.times.size())},
            {"from", toText(track.times.front()) + " s"},
            {"to", toText(track.times.back()) + " s"},
            {"between rows", "cubics through parabolas of three rows"}};
}

}  // namespace

Engine mineEngine(OwnTrack track) {
    Engine engine;
    engine.name = "mine";
    engine.label = engine.product = "Mine";
    engine.role = Role::Guest;
    engine.isPartial = true;
    engine.look = {"#6a3fb5", "#b79cf5", {2, 3}, 2.4};
    engine.settings = [track](const Scene&) { return trackSettings(track); };
    engine.build = [track = std::move(track)](const Scene& scene) -> std::unique_ptr<Simulation> {
        if (track.times.size() < 2) throw Unsupported("there is no track");
        requireSteps(track, scene);
        return std::make_unique<OwnTrackSimulation>(scene, track, bodyOf(track, scene));
    };
    return engine;
}

}  // namespace plumb::compare
