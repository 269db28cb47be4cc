// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

#include <compare/engine/arrivals.h>
#include <compare/engine/chipmunk/chipmunk_body.h>
#include <compare/engine/chipmunk/chipmunk_card.h>
#include <compare/engine/chipmunk/chipmunk_contacts.h>
#include <compare/engine/chipmunk/chipmunk_joint.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/outside_notes.h>
#include <compare/field/scene_fields.h>
#include <compare/mover/scene_movers.h>
#include <compare/scene/bench.h>

namespace plumb::compare {
namespace {

// Measured: a run of each takes more than a minute; spinner takes 0.2 s a step from the start.
constexpr std::array<std::string_view, 6> slow{"joint_grid", "spinner", "junkyard", "compounds", "washer", "rain"};

constexpr const char* noMoversOfChipmunk =
    "The mover is in Chipmunk a dynamic body that cannot turn, told its velocity before each step.";
constexpr double unknownInChipmunk = std::numeric_limits<double>::quiet_NaN();
constexpr double chipmunkSlop = 0.005;  // Box2D's value; Chipmunk's own value, 0.1, is made for pixels [m]
// Chipmunk's own value, gravity times dt, is 0.16 m/s; with it, a block that is tipping over falls asleep [m/s].
constexpr double chipmunkIdleSpeed = 0.01;
constexpr double chipmunkTimeToSleep = 0.5;  // Box2D's value; by default, nothing sleeps in Chipmunk [s]

/// Debian's build of Chipmunk prints a greeting on the standard output when the first space is made. The standard
/// output belongs to a report.
class QuietOutput {
public:
    QuietOutput() {
        std::fflush(stdout);
        const int nowhere = open("/dev/null", O_WRONLY);
        if (nowhere < 0) return;
        kept_ = dup(STDOUT_FILENO);
        dup2(nowhere, STDOUT_FILENO);
        close(nowhere);
    }
    ~QuietOutput() {
        std::fflush(stdout);
        if (kept_ < 0) return;
        dup2(kept_, STDOUT_FILENO);
        close(kept_);
    }
    QuietOutput(const QuietOutput&) = delete;
    QuietOutput& operator=(const QuietOutput&) = delete;

private:
    int kept_ = -1;
};

const EngineNumber chipmunkIterations{"iterations", 10, 1, 1000};
const EngineNumber chipmunkSlopNumber{"slop", chipmunkSlop, 0, 1};

OwnedChipmunk<cpSpace> newChipmunkSpace(const Scene& scene) {
    static const bool greeted = [] {
        const QuietOutput quiet;
        return OwnedChipmunk<cpSpace>(cpSpaceNew()) != nullptr;
    }();
    static_cast<void>(greeted);
    OwnedChipmunk<cpSpace> space(cpSpaceNew());
    cpSpaceSetGravity(space.get(), toChipmunk(scene.gravity));
    cpSpaceSetCollisionSlop(space.get(), numberFor(chipmunkCard().name, chipmunkSlopNumber, scene));
    cpSpaceSetIterations(space.get(), static_cast<int>(numberFor(chipmunkCard().name, chipmunkIterations, scene)));
    cpSpaceSetIdleSpeedThreshold(space.get(), chipmunkIdleSpeed);
    if (scene.sleeping) cpSpaceSetSleepTimeThreshold(space.get(), chipmunkTimeToSleep);
    return space;
}

class ChipmunkSimulation : public Simulation {
public:
    explicit ChipmunkSimulation(const Scene& scene)
        : fields_(scene),
          movers_(scene),
          wrap_(scene.wrap),
          probes_(scene.probes.size()),
          arrivals_(scene),
          sleeping_(scene.sleeping),
          filtered_(hasChipmunkFilters(scene)),
          space_(newChipmunkSpace(scene)) {
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            bodies_.push_back(bodyIsThereAtStart(scene, i) ? made(scene, i) : nullptr);
        join(scene);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            if (bodies_[i]) layToSleep(scene, i);
        for (std::size_t i = 0; i < scene.probes.size(); ++i) watch(scene, scene.probes[i], probes_[i]);
        contacts_.filters = !filtered_;
        listenToChipmunk(*space_, scene, contacts_);
    }

    /// Wakes all bodies: Chipmunk would not free the contacts that it keeps for sleeping ones.
    ~ChipmunkSimulation() override {
        for (const std::unique_ptr<ChipmunkBody>& body : bodies_)
            if (body) cpBodyActivate(body->body.get());
    }
    ChipmunkSimulation(const ChipmunkSimulation&) = delete;
    ChipmunkSimulation& operator=(const ChipmunkSimulation&) = delete;

    void step(double dt) override {
        for (const Arrivals::Due& due : arrivals_.dueBefore(tick_++)) arrive(due);
        if (!movers_.empty()) move(dt);
        for (const std::size_t body : sleepless_) cpBodyActivate(bodies_[body]->body.get());
        cpSpaceStep(space_.get(), dt);
        if (wrap_.any()) bringBack();
        lastDt_ = dt;
        breakJoints();
    }

    std::vector<BodyState> states() const override {
        std::vector<BodyState> result;
        result.reserve(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            result.push_back(bodies_[i] ? stateOfChipmunk(*bodies_[i]) : arrivals_.awaited(i));
        return result;
    }

    std::vector<double> probeValues() const override {
        std::vector<double> result;
        result.reserve(probes_.size());
        for (const Watched& probe : probes_) result.push_back(valueOf(probe));
        return result;
    }

    Broken brokenJoints() const override { return breakable_.empty() ? Broken{} : broken_; }

private:
    struct Watched {
        std::optional<std::pair<std::size_t, std::size_t>> pair{};  // of bodies
        std::optional<std::size_t> joint{};
        std::optional<std::size_t> gate{};  // index of the gate in the list of bodies whose sensors count
    };

    std::unique_ptr<ChipmunkBody> made(const Scene& scene, std::size_t index) {
        auto body = addChipmunkBody(*space_, asMoved(scene, scene.bodies[index]), index, filtered_);
        const bool dynamic = cpBodyGetType(body->body.get()) == CP_BODY_TYPE_DYNAMIC;
        if (!fields_.empty()) body->forces = &forces_;
        const bool kept = !body->canSleep || !fields_.empty();
        if (sleeping_ && dynamic && kept && std::ranges::find(sleepless_, index) == sleepless_.end())
            sleepless_.push_back(index);
        return body;
    }

    /// To be called after the body's joints are made, because they wake it.
    void layToSleep(const Scene& scene, std::size_t index) {
        const ChipmunkBody& body = *bodies_[index];
        const bool dynamic = cpBodyGetType(body.body.get()) == CP_BODY_TYPE_DYNAMIC;
        if (!scene.bodies[index].def.awake && sleeping_ && dynamic && body.enabled) cpBodySleep(body.body.get());
    }

    ChipmunkJoint joined(const Scene& scene, const std::vector<JointGeometry>& joints, std::size_t index) {
        return addChipmunkJoint({*space_, scene, bodies_, joints}, joints[index], scene.joints[index].name);
    }

    void arrive(const Arrivals::Due& due) {
        const Scene& scene = arrivals_.scene();
        for (const std::size_t body : due.arrival.bodies) {
            if (due.again) takeOut(body);
            bodies_[body] = made(scene, body);
        }
        for (const std::size_t joint : due.arrival.joints) {
            joints_[joint] = joined(scene, arrivals_.joints(), joint);
            broken_[joint] = false;
        }
        for (const std::size_t body : due.arrival.bodies) layToSleep(scene, body);
    }

    /// When a body is taken out, its joints are taken out too.
    void takeOut(std::size_t body) {
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (holdsInChipmunk(joints_[i], bodies_[body]->body.get())) removeChipmunkJoint(*space_, joints_[i]);
        removeChipmunkBody(*space_, *bodies_[body]);
        bodies_[body] = nullptr;
    }

    /// Chipmunk has no movers, so its user sets velocities. In a step, bodies move first. A body that obstacles can
    /// stop gets its velocity after that, and before contacts are solved: otherwise it would go into walls.
    void move(double dt) {
        for (const MoverCommand& command : movers_.commands(states(), dt)) {
            ChipmunkBody& body = *bodies_[command.body];
            const cpVect velocity = toChipmunk(command.velocity);
            if (cpBodyGetType(body.body.get()) == CP_BODY_TYPE_DYNAMIC)
                body.wanted = velocity;
            else
                cpBodySetVelocity(body.body.get(), velocity);
            if (command.gravityScale) body.gravityScale = *command.gravityScale;
        }
    }

    /// Chipmunk's space does not wrap, so its user moves a body that has left it to the other side.
    void bringBack() {
        for (const std::unique_ptr<ChipmunkBody>& body : bodies_) {
            if (!body || cpBodyGetType(body->body.get()) == CP_BODY_TYPE_STATIC) continue;
            const Vec2 now = stateOfChipmunk(*body).position, inside = wrap_.place(now);
            if (inside != now) cpBodySetPosition(body->body.get(), toChipmunk(inside));
        }
    }

    /// Chipmunk has no fields, so its user computes their forces, once in each step for all bodies.
    FieldForce fieldForceOn(std::size_t body, double dt) {
        if (fieldTick_ != tick_) fieldForces_ = fields_.at(states(), dt);
        fieldTick_ = tick_;
        return fieldForces_[body];
    }

    /// Breaks joints that bear too much. In Chipmunk, the user has to check their forces.
    void breakJoints() {
        for (const auto& [index, breaking] : breakable_) {
            if (!joints_[index].there) continue;
            const ChipmunkImpulse impulse = chipmunkImpulseOf(joints_[index]);
            if (impulse.linear.norm() / *lastDt_ > breaking.force ||
                std::abs(impulse.angular) / *lastDt_ > breaking.torque)
                destroy(index);
        }
    }

    /// Destroys the joint, and the gears that couple it.
    void destroy(std::size_t index) {
        for (const auto& [gear, ends] : gears_)
            if ((ends.first == index || ends.second == index) && joints_[gear].there) destroy(gear);
        removeChipmunkJoint(*space_, joints_[index]);
        broken_[index] = true;
    }

    void join(const Scene& scene) {
        const std::vector<JointGeometry> joints = jointGeometries(scene);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            joints_.push_back(jointIsThereAtStart(scene, joints, i) ? joined(scene, joints, i) : ChipmunkJoint{});
            broken_.push_back(false);
            const Breaking breaking = breakingOf(joints[i].def);
            if (breaking.force < unlimited || breaking.torque < unlimited) breakable_.emplace_back(i, breaking);
            if (std::holds_alternative<GearJointDef>(joints[i].def))
                gears_.push_back({i, {joints[i].jointA, joints[i].jointB}});
        }
    }

    void watch(const Scene& scene, const Probe& probe, Watched& watched) {
        if (const auto* force = std::get_if<NormalForceProbe>(&probe.quantity)) {
            watched.pair = {bodyIndex(scene, force->bodyA), bodyIndex(scene, force->bodyB)};
        } else if (const auto* jointForce = std::get_if<JointForceProbe>(&probe.quantity)) {
            watched.joint = jointIndex(scene, jointForce->joint);
        } else if (const auto* count = std::get_if<SensorCountProbe>(&probe.quantity)) {
            watched.gate = contacts_.gates.size();
            contacts_.gates.push_back({bodyIndex(scene, count->body)});
        }
    }

    double valueOf(const Watched& probe) const {
        if (probe.gate) return contacts_.gates[*probe.gate].count;
        if (!lastDt_) return unknownInChipmunk;
        if (probe.pair) {
            const auto &a = bodies_[probe.pair->first], &b = bodies_[probe.pair->second];
            return a && b ? pressedInChipmunk(a->body.get(), b->body.get()) / *lastDt_ : 0;
        }
        if (probe.joint && joints_[*probe.joint].there)
            return chipmunkImpulseOf(joints_[*probe.joint]).linear.norm() / *lastDt_;
        return unknownInChipmunk;
    }

    ChipmunkContacts contacts_;
    SceneFields fields_;
    SceneMovers movers_;
    Wrap wrap_;
    std::vector<std::unique_ptr<ChipmunkBody>> bodies_;  // null before the body has appeared
    std::vector<ChipmunkJoint> joints_;
    Broken broken_;
    std::vector<std::pair<std::size_t, Breaking>> breakable_;
    std::vector<std::pair<std::size_t, std::pair<std::size_t, std::size_t>>> gears_;  // with the joints they couple
    std::vector<std::size_t> sleepless_;  // bodies that must not sleep although others may: Chipmunk has no such flag
    std::vector<FieldForce> fieldForces_;
    int fieldTick_ = 0;  // the tick of fieldForces_
    ChipmunkForces forces_ = [this](std::size_t body, double dt) { return fieldForceOn(body, dt); };
    std::vector<Watched> probes_;
    Arrivals arrivals_;
    bool sleeping_;
    bool filtered_;  // by Chipmunk itself
    int tick_ = 0;
    std::optional<double> lastDt_;  // [s]
    OwnedChipmunk<cpSpace> space_;  // last, so that it is freed first: then it still goes through its bodies
};

std::vector<Setting> chipmunkSettings(const Scene& scene) {
    const OwnedChipmunk<cpSpace> space = newChipmunkSpace(scene);
    constexpr double aSixtieth = 1.0 / 60;
    const double share = 1 - std::pow(cpSpaceGetCollisionBias(space.get()), aSixtieth);
    return {
        {"iterations", fmt::format("{}", cpSpaceGetIterations(space.get()))},
        {"slop", fmt::format("{} m", cpSpaceGetCollisionSlop(space.get()))},
        {"position correction", fmt::format("{:.3g} of the overlap in 1/60 s", share)},
        {"error correction of joints", "as much"},
        {"restitution threshold", "none"},
        {"mixing of materials",
         needsChipmunkMixing(scene) ? "by the user, told of each contact in each step" : "its own, of square roots"},
        {"filters", hasChipmunkFilters(scene) ? "its own" : "by the user, told of each contact as it begins"},
        {"joints that break", "looked at by the user after each step"},
        {"capsules", "segments with a radius"},
        {"chains, segments with neighbours", "segments without thickness"},
        {"tile maps", "a polygon a tile"},
        {"damping, fields", "by a velocity function on each body"},
        {"sleep",
         !scene.sleeping ? "off" : fmt::format("below {} m/s for {} s", chipmunkIdleSpeed, chipmunkTimeToSleep)},
        {"continuous collision", "none"},
        {"warm starting", "on"},
        {"SIMD", "none"},
        {"precision", "double"},
    };
}

/// Why a scene that measures speed is not run; empty if it is run.
std::string leftOutOfChipmunk(const BenchScene& scene) {
    if (scene.group == "random") return "random scenes are measured in Plumb and Box2D 3";
    if (std::ranges::find(slow, scene.name) != slow.end()) return "a run takes more than a minute";
    if (scene.name.ends_with("_32000") || scene.name.ends_with("_64000")) return "a step takes seconds";
    return "";
}

}  // namespace

Engine chipmunkEngine() {
    Engine engine{chipmunkCard(), {}, {}};
    engine.version = cpVersionString;
    engine.leavesOut = leftOutOfChipmunk;
    engine.notes = [](const Scene& scene) { return outsideNotes(scene, "Chipmunk", noMoversOfChipmunk); };
    engine.numbers = {chipmunkIterations, chipmunkSlopNumber};
    engine.settings = chipmunkSettings;
    engine.build = [](const Scene& scene) { return std::make_unique<ChipmunkSimulation>(scene); };
    return engine;
}

}  // namespace plumb::compare
