// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <box2d/box2d.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <compare/engine/arrivals.h>
#include <compare/engine/box2d24/box2d24_body.h>
#include <compare/engine/box2d24/box2d24_card.h>
#include <compare/engine/box2d24/box2d24_joint.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/outside_notes.h>
#include <compare/engine/single.h>
#include <compare/field/scene_fields.h>
#include <compare/mover/scene_movers.h>
#include <compare/scene/bench.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {
namespace {

const EngineNumber velocityIterations{"velocityIterations", 8, 1, 1000};
const EngineNumber positionIterations{"positionIterations", 3, 1, 1000};

int iterationsIn(const Scene& scene, const EngineNumber& number) {
    return static_cast<int>(numberFor(box2d24Card().name, number, scene));
}

/// By default, 0 if the scene bounces, else Box2D's default; the scene may set another value [m/s].
EngineNumber thresholdIn24(const Scene& scene) {
    return {"restitutionThreshold", static_cast<double>(restitutionThreshold24(scene)), 0, 1e6};
}

double threshold24(const Scene& scene) {
    return numberFor(box2d24Card().name, thresholdIn24(scene), scene);
}

constexpr const char* noMoversOfBox2d24 =
    "The mover is in Box2D 2.4 a dynamic body that cannot turn, told its velocity before each step.";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Sums the impulses with which a pair of bodies press on each other in a step, with time-of-impact sub-steps.
struct PressedPair {
    b2Body *a, *b;
    double impulse = 0;  // in this step [N s]
    double force = 0;    // mean force over the last step in which they were awake [N]
};

/// A body with sensors, and how often something has entered them.
struct Gate {
    const b2Body* body;
    int count = 0;
};

class ContactListener : public b2ContactListener {
public:
    std::vector<PressedPair> pairs;
    std::vector<Gate> gates;

    void BeginContact(b2Contact* contact) override {
        mixSurfaces24(*contact);
        for (Gate& gate : gates)
            for (const b2Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()})
                if (fixture->IsSensor() && fixture->GetBody() == gate.body) ++gate.count;
    }

    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        for (PressedPair& pair : pairs) {
            if (!((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a))) continue;
            for (int i = 0; i < impulse->count; ++i) pair.impulse += static_cast<double>(impulse->normalImpulses[i]);
        }
    }

    void finishStep(double dt) {
        for (PressedPair& pair : pairs) {
            // While the bodies sleep, nothing is solved or reported, but they still press on each other.
            const bool asleep = !moves(*pair.a) && !moves(*pair.b);
            if (!asleep) pair.force = pair.impulse / dt;
            pair.impulse = 0;
        }
    }

private:
    static bool moves(const b2Body& body) { return body.GetType() != b2_staticBody && body.IsAwake(); }
};

class Box2d24Simulation : public Simulation {
public:
    explicit Box2d24Simulation(const Scene& scene)
        : world_(toBox2d24(scene.gravity)),
          fields_(scene),
          movers_(scene),
          wrap_(scene.wrap),
          probes_(scene.probes.size()),
          arrivals_(scene),
          threshold_(static_cast<float>(threshold24(scene))),
          velocityIterations_(iterationsIn(scene, velocityIterations)),
          positionIterations_(iterationsIn(scene, positionIterations)) {
        world_.SetAllowSleeping(scene.sleeping);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            bodies_.push_back(bodyIsThereAtStart(scene, i) ? made(scene, i) : nullptr);
        join(scene);
        for (std::size_t i = 0; i < scene.probes.size(); ++i) watch(scene, scene.probes[i], probes_[i]);
        // A listener is called for every contact in every step, which costs time: so it is set only if it is needed.
        if (!listener_.pairs.empty() || !listener_.gates.empty() || !surfaces_.empty())
            world_.SetContactListener(&listener_);
    }

    void step(double dt) override {
        for (const Arrivals::Due& due : arrivals_.dueBefore(tick_++)) arrive(due);
        if (!fields_.empty()) applyFields(dt);
        if (!movers_.empty()) move(dt);
        world_.Step(static_cast<float>(dt), velocityIterations_, positionIterations_);
        listener_.finishStep(dt);
        if (wrap_.any()) bringBack();
        lastDt_ = dt;
        breakJoints();
    }

    std::vector<BodyState> states() const override {
        std::vector<BodyState> result;
        result.reserve(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            result.push_back(bodies_[i] != nullptr ? stateOf24(*bodies_[i]) : arrivals_.awaited(i));
        return result;
    }

    std::vector<Phase> phases() const override {
        const b2Profile& profile = world_.GetProfile();
        const auto phase = [](const char* name, float milliseconds) {
            return Phase{name, static_cast<double>(milliseconds) / 1000};
        };
        return {phase("collide", profile.collide), phase("solve", profile.solve - profile.broadphase),
                phase("broad phase", profile.broadphase), phase("time of impact", profile.solveTOI)};
    }

    std::vector<double> probeValues() const override {
        std::vector<double> result;
        result.reserve(probes_.size());
        for (const Watched& probe : probes_) result.push_back(valueOf(probe));
        return result;
    }

    void makeBullets(const Scene& scene) {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!scene.bodies[i].def.velocity.isZero(0)) bodies_[i]->SetBullet(true);
    }

    Broken brokenJoints() const override {
        if (breakable_.empty()) return {};
        Broken broken;
        for (const b2Joint* joint : joints_) broken.push_back(joint == nullptr);
        return broken;
    }

private:
    struct Watched {
        std::optional<std::size_t> pair;  // index of a pressed pair
        std::optional<std::size_t> joint;
        std::optional<std::size_t> gate;  // index of a body whose sensors count
    };

    b2Body* made(const Scene& scene, std::size_t index) {
        return addBody24(world_, asMoved(scene, scene.bodies[index]), threshold_, surfaces_);
    }

    /// When a body is taken out, its joints are taken out too.
    void arrive(const Arrivals::Due& due) {
        const Scene& scene = arrivals_.scene();
        for (const std::size_t body : due.arrival.bodies) {
            if (due.again) world_.DestroyBody(bodies_[body]);
            bodies_[body] = made(scene, body);
        }
        for (const std::size_t joint : due.arrival.joints)
            joints_[joint] =
                addJoint24({world_, scene, bodies_, joints_}, arrivals_.joints()[joint], scene.joints[joint].name);
    }

    /// Box2D has no movers, so its user sets velocities before each step.
    void move(double dt) {
        for (const MoverCommand& command : movers_.commands(states(), dt)) {
            b2Body& body = *bodies_[command.body];
            body.SetLinearVelocity(toBox2d24(command.velocity));
            if (command.gravityScale) body.SetGravityScale(toSingle(*command.gravityScale));
        }
    }

    /// Box2D's world does not wrap, so its user moves a body that has left it to the other side.
    void bringBack() {
        for (b2Body* body : bodies_) {
            if (body->GetType() == b2_staticBody) continue;
            const Vec2 now = stateOf24(*body).position, inside = wrap_.place(now);
            if (inside != now) body->SetTransform(toBox2d24(inside), body->GetAngle());
        }
    }

    /// Box2D has no fields, so its user applies forces before each step.
    void applyFields(double dt) {
        const std::vector<FieldForce> forces = fields_.at(states(), dt);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i]->GetType() != b2_dynamicBody) continue;
            bodies_[i]->ApplyForceToCenter(toBox2d24(forces[i].force), true);
            bodies_[i]->ApplyTorque(toSingle(forces[i].torque), true);
        }
    }

    /// Breaks joints that bear too much. In Box2D 2.4, the user has to check their forces.
    void breakJoints() {
        const auto inverseDt = static_cast<float>(1 / *lastDt_);
        for (const auto& [index, breaking] : breakable_) {
            const b2Joint* joint = joints_[index];
            if (!joint) continue;
            const auto force = static_cast<double>(joint->GetReactionForce(inverseDt).Length());
            const auto torque = static_cast<double>(joint->GetReactionTorque(inverseDt));
            if (force > breaking.force || std::abs(torque) > breaking.torque) destroy(index);
        }
    }

    /// Destroys the gears that couple the joint, and then the joint.
    void destroy(std::size_t index) {
        for (const auto& [gear, ends] : gears_)
            if ((ends.first == index || ends.second == index) && joints_[gear]) destroy(gear);
        world_.DestroyJoint(joints_[index]);
        joints_[index] = nullptr;
    }

    void join(const Scene& scene) {
        const std::vector<JointGeometry> joints = jointGeometries(scene);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            joints_.push_back(jointIsThereAtStart(scene, joints, i)
                                  ? addJoint24({world_, scene, bodies_, joints_}, joints[i], scene.joints[i].name)
                                  : nullptr);
            const Breaking breaking = breakingOf(joints[i].def);
            if (breaking.force < unlimited || breaking.torque < unlimited) breakable_.emplace_back(i, breaking);
            if (std::holds_alternative<GearJointDef>(joints[i].def))
                gears_.push_back({i, {joints[i].jointA, joints[i].jointB}});
        }
    }

    void watch(const Scene& scene, const Probe& probe, Watched& watched) {
        if (const auto* force = std::get_if<NormalForceProbe>(&probe.quantity)) {
            watched.pair = listener_.pairs.size();
            listener_.pairs.push_back(
                {bodies_[bodyIndex(scene, force->bodyA)], bodies_[bodyIndex(scene, force->bodyB)]});
        } else if (const auto* jointForce = std::get_if<JointForceProbe>(&probe.quantity)) {
            watched.joint = jointIndex(scene, jointForce->joint);
        } else if (const auto* count = std::get_if<SensorCountProbe>(&probe.quantity)) {
            watched.gate = listener_.gates.size();
            listener_.gates.push_back({bodies_[bodyIndex(scene, count->body)]});
        }
    }

    double valueOf(const Watched& probe) const {
        if (probe.gate) return listener_.gates[*probe.gate].count;
        if (!lastDt_) return unknown;
        if (probe.pair) return listener_.pairs[*probe.pair].force;
        if (probe.joint && joints_[*probe.joint])
            return joints_[*probe.joint]->GetReactionForce(static_cast<float>(1 / *lastDt_)).Length();
        return unknown;
    }

    ContactListener listener_;
    Surfaces24 surfaces_;
    b2World world_;
    SceneFields fields_;
    SceneMovers movers_;
    Wrap wrap_;
    std::vector<b2Body*> bodies_;
    std::vector<b2Joint*> joints_;  // null if the joint has broken
    std::vector<std::pair<std::size_t, Breaking>> breakable_;
    std::vector<std::pair<std::size_t, std::pair<std::size_t, std::size_t>>> gears_;  // with the joints they couple
    std::vector<Watched> probes_;
    Arrivals arrivals_;
    float threshold_;  // restitution threshold [m/s]
    int velocityIterations_, positionIterations_;
    int tick_ = 0;
    std::optional<double> lastDt_;  // [s]
};

std::vector<Setting> box2d24Settings(const Scene& scene) {
    return {
        {"velocity iterations", fmt::format("{}", iterationsIn(scene, velocityIterations))},
        {"position iterations", fmt::format("{}", iterationsIn(scene, positionIterations))},
        {"restitution threshold", fmt::format("{} m/s", threshold24(scene))},
        {"slop", fmt::format("{} m", b2_linearSlop)},
        {"skin of polygons and segments", fmt::format("{} m", b2_polygonRadius)},
        {"position correction", fmt::format("{} of the overlap a step", b2_baumgarte)},
        {"joints that break", "looked at by the user after each step"},
        {"capsules", "a box and two discs, with the capsule's mass"},
        {"rounded polygons", "a skin of their radius, with the rounded one's mass"},
        {"chains, segments with neighbours", "solid on the right of their direction only"},
        {"sleep",
         !scene.sleeping ? "off" : fmt::format("below {} m/s for {} s", b2_linearSleepTolerance, b2_timeToSleep)},
        {"continuous collision", "against static bodies"},
        {"warm starting", "on"},
        {"SIMD", "none"},
        {"precision", "single"},
    };
}

/// The card, with the version; of the variant with bullets, if so.
EngineCard cardOf(bool bullets) {
    EngineCard card = box2d24Card();
    card.version = PLUMB_BOX2D24_VERSION;
    return bullets ? asBullets(card, {2, 4}) : card;
}

/// Why a scene that measures speed is not run; empty if it is run.
std::string leftOutOfBox2d24(const BenchScene& scene) {
    if (scene.group == "random") return "random scenes are measured in Plumb and Box2D 3";
    static const std::map<std::string, std::string> reasons{
        // Measured: the first step takes 0.2 s, the twelfth 8 s.
        {"spinner",
         "a step takes seconds: Box2D 2.4 enlarges boxes by four times a step's motion, and the paddle's tip makes "
         "1.7 m a step"},
        // Measured: 0.6 s a step for junkyard, and as much for washer.
        {"junkyard", "a run takes minutes"},
        {"washer", "a run takes minutes"},
        // Measured: 0.2 s a step with 16,000 bodies, 2.7 s with 64,000.
        {"pile_32000", "a step takes seconds"},
        {"pile_64000", "a step takes seconds"},
        {"pyramids_32000", "a step takes seconds"},
        {"pyramids_64000", "a step takes seconds"},
    };
    const auto reason = reasons.find(scene.name);
    return reason == reasons.end() ? "" : reason->second;
}

}  // namespace

Engine box2d24Engine(bool bullets) {
    Engine engine{cardOf(bullets), box2d24Settings, {}};
    engine.numbers = {velocityIterations, positionIterations, thresholdIn24({})};
    engine.build = [bullets](const Scene& scene) {
        auto simulation = std::make_unique<Box2d24Simulation>(scene);
        if (bullets) simulation->makeBullets(scene);
        return simulation;
    };
    engine.withBullets = [] { return box2d24Engine(true); };
    engine.leavesOut = leftOutOfBox2d24;
    engine.notes = [](const Scene& scene) { return outsideNotes(scene, "Box2D", noMoversOfBox2d24); };
    return engine;
}

}  // namespace plumb::compare
