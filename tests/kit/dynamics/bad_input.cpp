// SPDX-License-Identifier: MIT
#include "kit/dynamics/bad_input.h"

#include <sstream>
#include <stdexcept>

#include "kit/dynamics/described_leaves.h"

namespace plumb::test {

namespace {

/// Writes numbers so that no two differ by a bit and read alike.
class Writer {
public:
    Writer() { out_.precision(17); }
    std::string text() const { return out_.str(); }

    void operator()(const std::string& name, double value) { out_ << ' ' << name << '=' << value; }
    void operator()(const std::string& name, const Vec2& v) {
        out_ << ' ' << name << "=(" << v.x() << ' ' << v.y() << ')';
    }
    void count(const char* name, std::uint64_t n) { out_ << ' ' << name << '=' << n; }
    void id(const char* name, std::uint32_t index, std::uint32_t generation) {
        out_ << ' ' << name << '=' << index << '.' << generation;
    }
    void line(const char* what) { out_ << '\n' << what; }

private:
    std::ostringstream out_;
};

/// All that a definition says of itself, but for rules, which are code, and tile maps.
template <class Def>
void writeDef(Writer& write, const Def& def) {
    forEachLeaf(def, [&]<class T>(const std::string& name, const Member&, const T& value) {
        if constexpr (std::is_arithmetic_v<T>) write(name, static_cast<double>(value));
        if constexpr (std::is_enum_v<T>) write.count(name.c_str(), static_cast<std::uint64_t>(value));
        if constexpr (std::is_same_v<T, Vec2>) write(name, value);
        if constexpr (std::is_same_v<T, std::vector<Vec2>>)
            for (const Vec2& point : value) write(name, point);
        if constexpr (requires { value.generation; }) write.id(name.c_str(), value.index, value.generation);
    });
}

void writeJoint(Writer& write, const JointView& joint) {
    write.line("joint");
    const JointDef def = joint.def();
    write.count("kind", def.index());
    std::visit([&](const auto& kind) { writeDef(write, kind); }, def);
    write("coordinate", Vec2(joint.coordinate().value, joint.coordinate().speed));
    write("force", joint.reaction().force);
    write("torque", joint.reaction().torque);
    write("error", Vec2(joint.error(), joint.angleError()));
}

void writeShape(Writer& write, const ShapeDef& def) {
    write.line("  shape");
    write.count("kind", def.shape.index());
    writeDef(write, def);
}

void writeBody(Writer& write, const World& world, BodyId id) {
    const BodyView body = world.body(id);
    write.line("body");
    write.id("id", id.index, id.generation);
    write.count("type", static_cast<std::uint64_t>(body.type()));
    write("position", body.position());
    write("angle", body.angle());
    write("center", body.centerOfMass());
    write("velocity", body.velocity());
    write("angularVelocity", body.angularVelocity());
    write("mass", Vec2(body.mass(), body.inertia()));
    write("gravityScale", body.gravityScale());
    write("damping", Vec2(body.linearDamping(), body.angularDamping()));
    write.count("flags", body.awake() + 2u * body.enabled() + 4u * body.quarantined());
    write.count("tag", body.tag());
    write.count("joints", body.joints().size());
    for (const Contact& contact : body.contacts())
        for (const ContactPoint& point : contact.points) {
            write("at", point.position);
            write("force", Vec2(point.normalForce, point.frictionForce));
        }
    for (const ShapeId shape : body.shapes()) writeShape(write, world.shape(shape).def());
}

bool isSound(const BodyView& body) {
    return body.position().allFinite() && std::isfinite(body.angle()) && body.velocity().allFinite() &&
           std::isfinite(body.angularVelocity());
}

}  // namespace

Bench::Bench() {
    floor = world.add({.type = BodyType::Static, .shapes = {box({20, 0.5}), chain({{-20, 2}, {-19, 1}, {-18, 1}})}});
    wall = world.add({.type = BodyType::Static, .position = {0, 6}});
    lift =
        world.add({.type = BodyType::Kinematic, .position = {8, 3}, .velocity = {0, 0.1}, .shapes = {box({1, 0.2})}});
    ball = world.add({.position = {0, 4}, .shapes = {circle(0.5), {.shape = Circle{.radius = 1}, .sensor = true}}});
    crate = world.add({.position = {2, 4}, .shapes = {box({0.5, 0.5})}});
    sleeper = world.add({.position = {-6, 1}, .awake = false, .shapes = {box({0.5, 0.5})}});
    world.add({.position = {8, 3.5}, .shapes = {capsule({-0.3, 0}, {0.3, 0}, 0.2)}});
    hinge = world.join(RevoluteJointDef{.bodyA = wall, .bodyB = ball, .anchor = {0, 6}});
    slide = world.join(PrismaticJointDef{.bodyA = wall, .bodyB = crate, .anchor = {2, 4}});
    rod = world.join(DistanceJointDef{.bodyA = ball, .bodyB = crate, .anchorA = {0, 4}, .anchorB = {2, 4}});
    for (int i = 0; i < 5; ++i) world.step(1.0 / 60);
    gone = world.add({.position = {100, 0}, .shapes = {circle(0.5)}});
    goneJoint = world.join(FilterJointDef{gone, ball});
    goneShape = world.add(ball, circle(0.1));
    world.remove(goneShape);
    world.remove(gone);
    foreign = other.add({.shapes = {circle(0.5)}});
    foreignJoint = other.join(RevoluteJointDef{.bodyA = other.add({.type = BodyType::Static}), .bodyB = foreign});
    ballShape = {ball, 0};
    liftShape = {lift, 0};
}

std::string stateOf(const World& world) {
    Writer write;
    write.count("hash", stateHash(world));
    write("gravity", world.gravity());
    const WorldCounts counts = world.counts();
    write.count("bodies", counts.bodies);
    write.count("awake", counts.awakeBodies);
    write.count("shapes", counts.shapes);
    write.count("joints", counts.joints);
    write.count("contacts", counts.contacts);
    write.count("touching", counts.touchingContacts);
    write.count("colours", counts.colours);
    write.count("begins", world.contactBegins().size());
    write.count("ends", world.contactEnds().size());
    for (const BodyId id : world.bodies()) writeBody(write, world, id);
    for (const JointId id : world.joints()) {
        write.id("id", id.index, id.generation);
        writeJoint(write, world.joint(id));
    }
    return write.text();
}

std::string refusalOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& fault) {
        return fault.what();
    }
    return {};
}

std::string faultOf(Bench& bench, const std::function<void()>& call, const std::string& field,
                    const std::string& complaint) {
    const std::string before = stateOf(bench.world);
    const std::string refusal = refusalOf(call);
    const std::string wanted = field + ": ... " + complaint;
    if (refusal.empty()) return "was taken, not refused by \"" + wanted + "\"";
    const bool named = refusal.starts_with(field + ": ") && refusal.find(complaint) != std::string::npos;
    if (!named) return "was refused by \"" + refusal + "\", not by \"" + wanted + "\"";
    if (stateOf(bench.world) != before) return "changed the world, and was then refused by \"" + refusal + "\"";
    return {};
}

std::string unsoundAfter(World& world) {
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
    for (const BodyId id : world.bodies())
        if (!isSound(world.body(id)) && !world.body(id).quarantined())
            return "body " + std::to_string(id.index) + " is neither finite nor in quarantine";
    return {};
}

std::string unsoundOrQuarantinedAfter(World& world) {
    const std::string fault = unsoundAfter(world);
    if (!fault.empty()) return fault;
    for (const BodyId id : world.bodies())
        if (world.body(id).quarantined()) return "body " + std::to_string(id.index) + " is in quarantine";
    return {};
}

}  // namespace plumb::test
