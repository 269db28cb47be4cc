// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <fmt/format.h>

#include <limits>

#include <compare/engine/arrivals.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/plumb_movers.h>
#include <compare/engine/plumb_pushes.h>
#include <compare/engine/plumb_world.h>
#include <plumb/record/state_hash.h>

namespace plumb::compare {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

class PlumbSimulation : public Simulation {
public:
    PlumbSimulation(const Scene& scene, const SolverSettings& solver, bool accounts)
        : accounts_(accounts),
          made_(plumbWorld(scene, {.ledger = accounts, .solver = solver})),
          movers_(scene, made_),
          arrivals_(scene) {
        for (const Probe& probe : scene.probes) {
            if (const auto* count = std::get_if<SensorCountProbe>(&probe.quantity))
                gates_.push_back({made_.bodies[bodyIndex(scene, count->body)], values_.size()});
            values_.push_back(reader(scene, probe));
        }
        for (const SceneJoint& joint : scene.joints) {
            const Breaking breaking = breakingOf(joint.def);
            breaks_ = breaks_ || breaking.force < unlimited || breaking.torque < unlimited;
        }
    }

    void step(double dt) override {
        for (const Arrivals::Due& due : arrivals_.dueBefore(tick_++)) arrive(due);
        movers_.step(made_.world, dt);
        made_.world.step(dt);
        stepped_ = true;
        for (Gate& gate : gates_)
            for (const SensorBegin& begin : made_.world.sensorBegins())
                if (begin.sensor.body == gate.body) ++gate.visits;
    }

    std::vector<BodyState> states() const override {
        std::vector<BodyState> result;
        result.reserve(made_.bodies.size());
        for (std::size_t i = 0; i < made_.bodies.size(); ++i) {
            const BodyId id = made_.bodies[i];
            if (!made_.world.contains(id)) {
                result.push_back(arrivals_.awaited(i));
                continue;
            }
            const BodyView body = made_.world.body(id);
            result.push_back({body.position(), body.angle(), body.velocity(), body.angularVelocity()});
        }
        return result;
    }

    std::optional<std::uint64_t> stateHash() const override { return plumb::stateHash(made_.world); }

    std::vector<Phase> phases() const override {
        const StepProfile profile = made_.world.profile();
        return {{"pairs", profile.pairs},
                {"collide", profile.collide},
                {"impacts", profile.impacts},
                {"solve", profile.solve},
                {"finish", profile.finish}};
    }

    std::vector<double> probeValues() const override {
        std::vector<double> result;
        result.reserve(values_.size());
        for (const auto& value : values_) result.push_back(stepped_ ? value() : unknown);
        for (const Gate& gate : gates_) result[gate.probe] = gate.visits;
        return result;
    }

    Broken brokenJoints() const override {
        if (!breaks_) return {};
        Broken broken;
        for (const JointId& joint : made_.joints) broken.push_back(!made_.world.contains(joint));
        return broken;
    }

    std::vector<Push> pushes() const override { return plumbPushes(made_); }

    std::vector<double> energyByCause() const override {
        if (!accounts_) return {};
        const EnergyLedger e = made_.world.ledger().energy;
        return {e.forces, e.drivers, e.motors, e.friction, e.impacts, e.damping, e.breaking, e.solver};
    }

    void hold(const std::optional<Hand>& hand) override {
        if (hand_ && made_.world.contains(*hand_)) made_.world.remove(*hand_);
        hand_.reset();
        const BodyId body = hand ? made_.bodies[hand->body] : BodyId{};
        if (!hand || !made_.world.contains(body)) return;
        const Vec2 anchor = made_.world.body(body).pose() * hand->grip;
        hand_ = made_.world.join(TargetJointDef{.body = body, .anchor = anchor, .target = hand->target});
    }

private:
    /// A body with sensors, and how often something has entered them.
    struct Gate {
        BodyId body;
        std::size_t probe;
        int visits = 0;
    };

    void arrive(const Arrivals::Due& due) {
        for (const std::size_t body : due.arrival.bodies) {
            if (due.again) made_.world.remove(made_.bodies[body]);
            putBody(made_, arrivals_.scene(), body);
        }
        for (const std::size_t joint : due.arrival.joints) putJoint(made_, arrivals_.joints()[joint], joint);
    }

    std::function<double()> reader(const Scene& scene, const Probe& probe) const {
        if (const auto* force = std::get_if<NormalForceProbe>(&probe.quantity)) {
            const BodyId a = made_.bodies[bodyIndex(scene, force->bodyA)];
            const BodyId b = made_.bodies[bodyIndex(scene, force->bodyB)];
            return [this, a, b] { return normalForce(a, b); };
        }
        if (const auto* force = std::get_if<JointForceProbe>(&probe.quantity)) {
            const JointId joint = made_.joints[jointIndex(scene, force->joint)];
            return [this, joint] {
                const World& world = made_.world;
                return world.contains(joint) ? world.joint(joint).reaction().force.norm() : unknown;
            };
        }
        return [] { return unknown; };
    }

    double normalForce(const BodyId& a, const BodyId& b) const {
        double sum = 0;
        for (const Contact& contact : made_.world.body(a).contacts()) {
            if (contact.shapeA.body != b && contact.shapeB.body != b) continue;
            for (const ContactPoint& point : contact.points) sum += point.normalForce;
        }
        return sum;
    }

    bool accounts_;
    PlumbWorld made_;
    PlumbMovers movers_;
    Arrivals arrivals_;
    std::optional<JointId> hand_;
    int tick_ = 0;
    std::vector<std::function<double()>> values_;
    std::vector<Gate> gates_;
    bool stepped_ = false;
    bool breaks_ = false;
};

std::vector<Setting> plumbSettings(const Scene& scene, const SolverSettings& solver) {
    return {
        {"sub-steps", fmt::format("{}", solver.subSteps)},
        {"contact stiffness",
         fmt::format("{} Hz, damping ratio {}", solver.contactFrequency, solver.contactDampingRatio)},
        {"overlap pushed out at most at", fmt::format("{} m/s", solver.contactPushSpeed)},
        {"sleep", !scene.sleeping ? "off" : fmt::format("below {} m/s for {} s", solver.sleepSpeed, solver.sleepTime)},
        {"restitution threshold", "none"},
        {"precision", "double; contact solver single, relative to the body"},
    };
}

constexpr const char* plumbName = "plumb";

/// The numbers are in the order in which solverFor reads them.
std::vector<EngineNumber> plumbNumbers(const SolverSettings& solver) {
    return {{"subSteps", static_cast<double>(solver.subSteps), 1, 64},
            {"contactFrequency", solver.contactFrequency, 1e-3, 1e6},
            {"contactDampingRatio", solver.contactDampingRatio, 0, 1e6},
            {"contactPushSpeed", solver.contactPushSpeed, 0, 1e6},
            {"sleepSpeed", solver.sleepSpeed, 0, 1e6},
            {"sleepTime", solver.sleepTime, 0, 1e6},
            {"ledger", 0, 0, 1}};
}

/// 1: it accounts for where energy comes from and goes to, which takes a little time.
bool accountsIn(const Scene& scene) {
    return numberFor(plumbName, plumbNumbers({}).back(), scene) != 0;
}

SolverSettings solverFor(const Scene& scene, SolverSettings solver) {
    const std::vector<EngineNumber> numbers = plumbNumbers(solver);
    const auto number = [&](std::size_t i) { return numberFor(plumbName, numbers[i], scene); };
    solver.subSteps = static_cast<int>(number(0));
    solver.contactFrequency = number(1);
    solver.contactDampingRatio = number(2);
    solver.contactPushSpeed = number(3);
    solver.sleepSpeed = number(4);
    solver.sleepTime = number(5);
    return solver;
}

}  // namespace

Engine plumbEngine(const SolverSettings& solver) {
    Engine engine;
    engine.name = plumbName;
    engine.version = PLUMB_VERSION;
    engine.label = engine.product = "Plumb";
    engine.role = Role::Subject;
    engine.look = {"#0072b2", "#56b4e9", {}, 2.5, true};
    engine.numbers = plumbNumbers(solver);
    engine.settings = [solver](const Scene& scene) { return plumbSettings(scene, solverFor(scene, solver)); };
    engine.build = [solver](const Scene& scene) {
        return std::make_unique<PlumbSimulation>(scene, solverFor(scene, solver), accountsIn(scene));
    };
    engine.withOneSubStep = [solver] {
        SolverSettings one = solver;
        one.subSteps = 1;
        return plumbEngine(one);
    };
    return engine;
}

}  // namespace plumb::compare
