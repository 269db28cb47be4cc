// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <box2d/box2d.h>
#include <box2d/constants.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <compare/engine/arrivals.h>
#include <compare/engine/box2d3/box2d3_body.h>
#include <compare/engine/box2d3/box2d3_card.h>
#include <compare/engine/box2d3/box2d3_joint.h>
#include <compare/engine/box2d3/box2d3_mover.h>
#include <compare/engine/box2d3/box2d3_pushes.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/outside_notes.h>
#include <compare/engine/single.h>
#include <compare/field/scene_fields.h>
#include <compare/mover/scene_movers.h>
#include <compare/scene/joint_geometry.h>
#include <compare/scene/shape_pair.h>

namespace plumb::compare {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool mixesAsUsual(const Scene& scene) {
    return std::ranges::all_of(scene.bodies, [](const SceneBody& body) {
        return std::ranges::all_of(body.def.shapes,
                                   [](const ShapeDef& shape) { return compare::mixesAsUsual(shape.material); });
    });
}

bool hasSensors(const Scene& scene) {
    return std::ranges::any_of(scene.bodies, [](const SceneBody& body) {
        return std::ranges::any_of(body.def.shapes, [](const ShapeDef& shape) { return shape.sensor; });
    });
}

const EngineNumber subStepsOf3{"subSteps", 4, 1, 64};

/// By default, 0 if the scene bounces, else Box2D's default [m/s].
EngineNumber thresholdIn3(const Scene& scene) {
    const double byDefault = static_cast<double>(b2DefaultWorldDef().restitutionThreshold);
    return {"restitutionThreshold", bounces(scene) ? 0 : byDefault, 0, 1e6};
}

EngineNumber maxSpeedOf3() {
    return {"maxSpeed", static_cast<double>(b2DefaultWorldDef().maximumLinearSpeed), 0.01, 1e6};
}

float numberIn3(const Scene& scene, const EngineNumber& number) {
    return static_cast<float>(numberFor(box2d3Card().name, number, scene));
}

/// subSteps: used if the scene does not set them.
int subStepsIn3(const Scene& scene, int subSteps) {
    EngineNumber number = subStepsOf3;
    number.byDefault = subSteps;
    return static_cast<int>(numberIn3(scene, number));
}

/// The default world, except sleep, mixing rules, gravity, and the restitution threshold of a scene that bounces.
b2WorldDef worldDef(const Scene& scene) {
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = toBox2d3(scene.gravity);
    def.restitutionThreshold = numberIn3(scene, thresholdIn3(scene));
    def.maximumLinearSpeed = numberIn3(scene, maxSpeedOf3());
    def.enableSleep = scene.sleeping;
    for (const SceneBody& body : scene.bodies) {
        const bool fixed = body.def.type == BodyType::Static;
        const int shapes = static_cast<int>(body.def.shapes.size());
        ++(fixed ? def.capacity.staticBodyCount : def.capacity.dynamicBodyCount);
        (fixed ? def.capacity.staticShapeCount : def.capacity.dynamicShapeCount) += shapes;
    }
    if (!mixesAsUsual(scene)) {
        def.frictionCallback = mixedFriction3;
        def.restitutionCallback = mixedRestitution3;
    }
    return def;
}

/// A world that is destroyed with its owner, because Box2D 3 can only have a limited number of worlds.
class World3 {
public:
    explicit World3(const b2WorldDef& def) : id_(b2CreateWorld(&def)) {
        if (!b2World_IsValid(id_)) throw std::runtime_error("Box2D 3 has no room for another world");
    }
    ~World3() { b2DestroyWorld(id_); }
    World3(const World3&) = delete;
    World3& operator=(const World3&) = delete;
    b2WorldId id() const { return id_; }

private:
    b2WorldId id_;
};

class Box2d3Simulation : public Simulation {
public:
    Box2d3Simulation(const Scene& scene, int subSteps)
        : subSteps_(subStepsIn3(scene, subSteps)),
          world_(worldDef(scene)),
          fields_(scene),
          movers_(scene, Characters::Capsules),
          wrap_(scene.wrap),
          probes_(scene.probes.size()),
          arrivals_(scene) {
        senses_ = hasSensors(scene);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            bodies_.push_back(bodyIsThereAtStart(scene, i) ? made(scene, i) : b2_nullBodyId);
            angles_.push_back(scene.bodies[i].def.angle);
        }
        join(scene);
        for (std::size_t i = 0; i < scene.probes.size(); ++i) probes_[i] = watch(scene, scene.probes[i]);
    }

    void step(double dt) override {
        for (const Arrivals::Due& due : arrivals_.dueBefore(tick_++)) arrive(due);
        if (!fields_.empty()) applyFields(dt);
        if (!movers_.empty()) move(dt);
        b2World_Step(world_.id(), static_cast<float>(dt), subSteps_);
        if (wrap_.any()) bringBack();
        lastDt_ = dt;
        if (breaks_) breakJoints();
        if (senses_) countVisits();
    }

    std::vector<BodyState> states() const override {
        std::vector<BodyState> result;
        result.reserve(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (B2_IS_NULL(bodies_[i])) {
                result.push_back(arrivals_.awaited(i));
                continue;
            }
            result.push_back(stateOf3(bodies_[i]));
            // Angles are counted on through whole turns: Box2D 3 turns a body by less than half a turn in one step.
            angles_[i] += std::remainder(result.back().angle - angles_[i], 2 * std::numbers::pi);
            result.back().angle = angles_[i];
        }
        return result;
    }

    std::vector<Phase> phases() const override {
        const b2Profile profile = b2World_GetProfile(world_.id());
        const auto phase = [](const char* name, float milliseconds) {
            return Phase{name, static_cast<double>(milliseconds) / 1000};
        };
        return {phase("pairs", profile.pairs),
                phase("collide", profile.collide),
                phase("prepare", profile.solverSetup),
                phase("constraints", profile.constraints),
                phase("transforms", profile.transforms),
                phase("events", profile.jointEvents + profile.hitEvents + profile.sensorHits),
                phase("refit", profile.refit),
                phase("continuous", profile.bullets),
                phase("sleep", profile.sleepIslands)};
    }

    std::vector<double> probeValues() const override {
        std::vector<double> result;
        result.reserve(probes_.size());
        for (const Watched& probe : probes_) result.push_back(valueOf(probe));
        return result;
    }

    void makeBullets(const Scene& scene) {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!scene.bodies[i].def.velocity.isZero(0)) b2Body_SetBullet(bodies_[i], true);
    }

    Broken brokenJoints() const override {
        if (!breaks_) return {};
        Broken broken;
        for (const b2JointId& joint : joints_) broken.push_back(!b2Joint_IsValid(joint));
        return broken;
    }

    std::vector<Push> pushes() const override {
        return lastDt_ ? pushes3({bodies_, joints_, geometries_, *lastDt_, subSteps_}) : std::vector<Push>{};
    }

    void hold(const std::optional<Hand>& hand) override {
        if (b2Joint_IsValid(hand_)) releaseHand3(hand_);
        hand_ = b2_nullJointId;
        if (hand && B2_IS_NON_NULL(bodies_[hand->body])) hand_ = handJoint3(world_.id(), bodies_[hand->body], *hand);
    }

private:
    struct Watched {
        std::optional<std::pair<b2BodyId, b2BodyId>> bodies;
        std::optional<std::size_t> joint;
        std::optional<b2BodyId> gate;  // the body whose sensors count
        int visits = 0;
    };

    b2BodyId made(const Scene& scene, std::size_t index) const {
        const SceneBody& body = scene.bodies[index];
        const b2BodyId id = addBody3(world_.id(), asMoved(scene, body, Characters::Capsules), senses_);
        if (isCharacter(scene, body, Characters::Capsules)) makeCharacter3(id);
        return id;
    }

    /// When a body is taken out, its joints are taken out too.
    void arrive(const Arrivals::Due& due) {
        const Scene& scene = arrivals_.scene();
        for (const std::size_t body : due.arrival.bodies) {
            if (due.again) b2DestroyBody(bodies_[body]);
            bodies_[body] = made(scene, body);
            angles_[body] = scene.bodies[body].def.angle;
        }
        for (const std::size_t joint : due.arrival.joints)
            joints_[joint] =
                addJoint3({world_.id(), scene, bodies_, scene.dt / subSteps_}, arrivals_.joints()[joint], joint);
    }

    /// Box2D has no movers, so its user sets velocities before each step. A character's velocity is found by Box2D's
    /// queries.
    void move(double dt) {
        for (const MoverCommand& command : movers_.commands(states(), dt)) {
            const b2BodyId body = bodies_[command.body];
            const Vec2 velocity =
                command.asCharacter ? characterVelocity3(world_.id(), body, command.velocity, dt) : command.velocity;
            b2Body_SetLinearVelocity(body, toBox2d3(velocity));
            if (command.gravityScale) b2Body_SetGravityScale(body, toSingle(*command.gravityScale));
        }
    }

    /// Box2D's world does not wrap, so its user moves a body that has left it to the other side.
    void bringBack() {
        for (const b2BodyId& body : bodies_) {
            if (b2Body_GetType(body) == b2_staticBody) continue;
            const Vec2 now = stateOf3(body).position, inside = wrap_.place(now);
            if (inside != now) b2Body_SetTransform(body, toBox2d3(inside), b2Body_GetRotation(body));
        }
    }

    /// Box2D has no fields, so its user applies forces before each step.
    void applyFields(double dt) {
        const std::vector<FieldForce> forces = fields_.at(states(), dt);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            b2Body_ApplyForceToCenter(bodies_[i], toBox2d3(forces[i].force), true);
            b2Body_ApplyTorque(bodies_[i], toSingle(forces[i].torque), true);
        }
    }

    void join(const Scene& scene) {
        geometries_ = jointGeometries(scene);
        for (std::size_t i = 0; i < geometries_.size(); ++i) {
            joints_.push_back(jointIsThereAtStart(scene, geometries_, i)
                                  ? addJoint3({world_.id(), scene, bodies_, scene.dt / subSteps_}, geometries_[i], i)
                                  : b2_nullJointId);
            const Breaking breaking = breakingOf(geometries_[i].def);
            if (breaking.force < unlimited || breaking.torque < unlimited) breaks_ = true;
        }
    }

    /// Removes the joints that bore too much. Box2D 3 reports them in events; the user has to remove them.
    void breakJoints() {
        const b2JointEvents events = b2World_GetJointEvents(world_.id());
        std::vector<std::size_t> broken;
        for (int i = 0; i < events.count; ++i) broken.push_back(jointOf3(events.jointEvents[i].userData));
        for (const std::size_t index : broken) {
            b2DestroyJoint(joints_[index]);
            joints_[index] = b2_nullJointId;
        }
    }

    void countVisits() {
        const b2SensorEvents events = b2World_GetSensorEvents(world_.id());
        for (int i = 0; i < events.beginCount; ++i) {
            const b2BodyId body = b2Shape_GetBody(events.beginEvents[i].sensorShapeId);
            for (Watched& probe : probes_)
                if (probe.gate && B2_ID_EQUALS(*probe.gate, body)) ++probe.visits;
        }
    }

    Watched watch(const Scene& scene, const Probe& probe) const {
        Watched watched;
        if (const auto* force = std::get_if<NormalForceProbe>(&probe.quantity))
            watched.bodies = {bodies_[bodyIndex(scene, force->bodyA)], bodies_[bodyIndex(scene, force->bodyB)]};
        else if (const auto* jointForce = std::get_if<JointForceProbe>(&probe.quantity))
            watched.joint = jointIndex(scene, jointForce->joint);
        else if (const auto* count = std::get_if<SensorCountProbe>(&probe.quantity))
            watched.gate = bodies_[bodyIndex(scene, count->body)];
        return watched;
    }

    double valueOf(const Watched& probe) const {
        if (probe.gate) return probe.visits;
        if (!lastDt_) return unknown;
        if (probe.bodies) return normalImpulse(probe.bodies->first, probe.bodies->second) / *lastDt_;
        // This is the force of the last sub-step, because Box2D 3 does not compute a mean for joints.
        if (probe.joint && b2Joint_IsValid(joints_[*probe.joint]))
            return static_cast<double>(b2Length(b2Joint_GetConstraintForce(joints_[*probe.joint])));
        return unknown;
    }

    /// The impulse over the last step. A contact that sleeps keeps its last impulse.
    static double normalImpulse(b2BodyId a, b2BodyId b) {
        std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(a)));
        contacts.resize(
            static_cast<std::size_t>(b2Body_GetContactData(a, contacts.data(), static_cast<int>(contacts.size()))));
        double sum = 0;
        for (const b2ContactData& contact : contacts) {
            const b2BodyId first = b2Shape_GetBody(contact.shapeIdA);
            const b2BodyId second = b2Shape_GetBody(contact.shapeIdB);
            if (!B2_ID_EQUALS(first, b) && !B2_ID_EQUALS(second, b)) continue;
            for (int i = 0; i < contact.manifold.pointCount; ++i)
                sum += static_cast<double>(contact.manifold.points[i].totalNormalImpulse);
        }
        return sum;
    }

    int subSteps_;
    World3 world_;
    SceneFields fields_;
    SceneMovers movers_;
    Wrap wrap_;
    std::vector<b2BodyId> bodies_;
    mutable std::vector<double> angles_;  // as last returned, counted on through whole turns [rad]
    std::vector<b2JointId> joints_;       // null if the joint has broken
    std::vector<JointGeometry> geometries_;
    b2JointId hand_ = b2_nullJointId;
    bool breaks_ = false, senses_ = false;
    std::vector<Watched> probes_;
    Arrivals arrivals_;
    int tick_ = 0;
    std::optional<double> lastDt_;  // [s]
};

std::vector<Setting> box2d3Settings(const Scene& scene, int subSteps) {
    const b2WorldDef world = worldDef(scene);
    const b2RevoluteJointDef joint = b2DefaultRevoluteJointDef();
    return {
        {"sub-steps", fmt::format("{}", subStepsIn3(scene, subSteps))},
        {"restitution threshold", fmt::format("{} m/s", world.restitutionThreshold)},
        {"contact stiffness", fmt::format("{} Hz, damping ratio {}", world.contactHertz, world.contactDampingRatio)},
        {"overlap pushed out at most at", fmt::format("{} m/s", world.contactSpeed)},
        {"joint stiffness",
         fmt::format("{} Hz, damping ratio {}", joint.base.constraintHertz, joint.base.constraintDampingRatio)},
        {"springs", "frequencies of the mass that they move at the start"},
        {"joints that break", "removed by the user when an event says so"},
        {"slop", fmt::format("{} m", B2_LINEAR_SLOP)},
        {"rounded polygons", "the mass of the rounded outline"},
        {"chains, segments with neighbours", "solid on the right of their direction only"},
        {"sleep", !scene.sleeping
                      ? "off"
                      : fmt::format("below {} m/s for {} s", b2DefaultBodyDef().sleepThreshold, B2_TIME_TO_SLEEP)},
        {"continuous collision", "against static bodies"},
        {"warm starting", "on"},
        {"threads", "1"},
        {"SIMD", "as the library was built"},
        {"precision", b2IsDoublePrecision() ? "double positions" : "single"},
    };
}

std::string version() {
    const b2Version v = b2GetVersion();
    return fmt::format("{}.{}.{}", v.major, v.minor, v.revision);
}

constexpr const char* stoppedMoverOfBox2d3 =
    "The mover is in Box2D 3, where it is a capsule, that engine's own character mover; another shape is a dynamic "
    "body "
    "that cannot turn, told its velocity before each step.";

}  // namespace

Engine box2d3Engine(bool bullets, int subSteps) {
    Engine engine{box2d3Card(), {}, {}};
    engine.version = version();
    if (bullets) static_cast<EngineCard&>(engine) = asBullets(engine, {4, 3, 1, 3});
    engine.numbers = {subStepsOf3, thresholdIn3({}), maxSpeedOf3()};
    engine.settings = [subSteps](const Scene& scene) { return box2d3Settings(scene, subSteps); };
    engine.build = [bullets, subSteps](const Scene& scene) {
        auto simulation = std::make_unique<Box2d3Simulation>(scene, subSteps);
        if (bullets) simulation->makeBullets(scene);
        return simulation;
    };
    engine.withBullets = [subSteps] { return box2d3Engine(true, subSteps); };
    engine.withOneSubStep = [bullets] { return box2d3Engine(bullets, 1); };
    engine.notes = [](const Scene& scene) { return outsideNotes(scene, "Box2D", stoppedMoverOfBox2d3); };
    return engine;
}

}  // namespace plumb::compare
