// SPDX-License-Identifier: MIT
#include <compare/metric/observation.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <compare/metric/joint_state.h>

namespace plumb::compare {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

bool holds(const Broken& broken, std::size_t joint) {
    return joint >= broken.size() || !broken[joint];
}

constexpr std::size_t mostJoints = 256;  // of which forces are asked

/// With a probe more for each of its joints.
Scene withJointsWatched(const Scene& scene) {
    Scene watched = scene;
    if (scene.joints.size() > mostJoints) return watched;
    for (const SceneJoint& joint : scene.joints)
        watched.probes.push_back({.name = joint.name, .quantity = JointForceProbe{joint.name}, .unit = "N"});
    return watched;
}

}  // namespace

/// Writes down what a simulation comes to.
class Run::Recorder {
public:
    explicit Recorder(const Scene& scene) : scene_(scene), joints_(scene_) {}

    const Scene& scene() const { return scene_; }

    void look(const Simulation& simulation, Observation& seen) const {
        seen.states.push_back(simulation.states());
        const Broken broken = simulation.brokenJoints();
        for (std::size_t i = 0; i < broken.size(); ++i) {
            if (seen.brokenAt.size() <= i) seen.brokenAt.resize(i + 1);
            if (broken[i] && !seen.brokenAt[i]) seen.brokenAt[i] = seen.states.size() - 1;
        }
        if (std::vector<double> causes = simulation.energyByCause(); !causes.empty())
            seen.energyByCause.push_back(std::move(causes));
        std::vector<double> row = simulation.probeValues();
        seen.jointForces.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(scene_.probes.size()), row.end());
        row.resize(scene_.probes.size());
        for (std::size_t i = 0; i < scene_.probes.size(); ++i)
            if (const auto* snags = std::get_if<SnagsProbe>(&scene_.probes[i].quantity))
                row[i] = snagsOf(*snags, seen, i);
            else if (isSeen(scene_.probes[i]))
                row[i] = valueOf(scene_.probes[i], seen.states.back(), broken);
        seen.probes.push_back(std::move(row));
    }

private:
    /// One more than before when the last step caught the body.
    double snagsOf(const SnagsProbe& probe, const Observation& seen, std::size_t index) const {
        if (seen.probes.empty()) return 0;
        const std::size_t body = bodyIndex(scene_, probe.body), now = seen.states.size() - 1;
        const auto speedAt = [&](std::size_t tick) { return seen.states[tick][body].velocity.dot(probe.direction); };
        return seen.probes.back()[index] + (speedAt(now - 1) - speedAt(now) <= probe.drop ? 0 : 1);
    }

    double valueOf(const Probe& probe, const std::vector<BodyState>& states, const Broken& broken) const {
        const auto stateOf = [&](const std::string& body) { return states[bodyIndex(scene_, body)]; };
        if (const auto* angle = std::get_if<AngleProbe>(&probe.quantity)) return stateOf(angle->body).angle;
        if (const auto* position = std::get_if<PositionProbe>(&probe.quantity))
            return stateOf(position->body).position.dot(position->direction);
        if (const auto* velocity = std::get_if<VelocityProbe>(&probe.quantity))
            return stateOf(velocity->body).velocity.dot(velocity->direction);
        if (const auto* apart = std::get_if<ApartProbe>(&probe.quantity))
            return (stateOf(apart->bodyB).position - stateOf(apart->bodyA).position).dot(apart->direction);
        if (const auto* limit = std::get_if<LimitProbe>(&probe.quantity)) {
            const std::size_t joint = jointIndex(scene_, limit->joint);
            return holds(broken, joint) ? joints_.beyondLimit(joint, states) : 0;
        }
        const auto& joint = std::get<JointBrokenProbe>(probe.quantity).joint;
        return holds(broken, jointIndex(scene_, joint)) ? 0 : 1;
    }

    Scene scene_;
    JointStates joints_;
};

Run::Run(const Scene& scene, const Engine& engine) : recorder_(std::make_unique<Recorder>(scene)) {
    seen_.engine = engine.name;
    seen_.version = engine.version;
    seen_.settings = engine.settings(scene);
    seen_.role = engine.role;
    seen_.partial = engine.isPartial;
    seen_.dt = scene.dt;
    try {
        simulation_ = engine.build(withJointsWatched(scene));
        recorder_->look(*simulation_, seen_);
    } catch (const Unsupported& reason) {
        seen_.unsupported = reason.what();
    }
}

Run::~Run() = default;
Run::Run(Run&&) noexcept = default;

bool Run::isOver() const {
    return !simulation_ || static_cast<int>(seen_.states.size()) > stepCount(recorder_->scene());
}

void Run::step() {
    const auto start = std::chrono::steady_clock::now();
    simulation_->step(seen_.dt);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    milliseconds_.push_back(taken.count());
    recorder_->look(*simulation_, seen_);
}

Observation Run::observation() && {
    if (simulation_) seen_.hash = simulation_->stateHash();
    if (!seen_.partial && !milliseconds_.empty()) seen_.msPerStep = median(std::move(milliseconds_));
    return std::move(seen_);
}

Observation observe(const Scene& scene, const Engine& engine) {
    Run run(scene, engine);
    while (!run.isOver()) run.step();
    return std::move(run).observation();
}

Broken brokenBy(const Observation& run, std::size_t tick) {
    Broken broken(run.brokenAt.size());
    for (std::size_t i = 0; i < broken.size(); ++i) broken[i] = run.brokenAt[i] && *run.brokenAt[i] <= tick;
    return broken;
}

bool isSeen(const Probe& probe) {
    const auto saidByEngine = [](const auto& quantity) {
        using T = std::decay_t<decltype(quantity)>;
        return std::is_same_v<T, NormalForceProbe> || std::is_same_v<T, JointForceProbe> ||
               std::is_same_v<T, SensorCountProbe>;
    };
    return !std::visit(saidByEngine, probe.quantity);
}

bool isFinite(const BodyState& state) {
    return state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.angle) &&
           std::isfinite(state.angularVelocity);
}

}  // namespace plumb::compare
