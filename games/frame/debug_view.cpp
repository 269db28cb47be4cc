// SPDX-License-Identifier: MIT
#include <games/frame/debug_view.h>

#include <cmath>
#include <cstdio>

#include <games/frame/canvas.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::games {
namespace {

constexpr Color fixed = Color::hex(0xb8bcc8), driven = Color::hex(0x5fb4ff), awake = Color::hex(0xffa04d),
                asleep = Color::hex(0x8d7bc0), sensor = Color::hex(0x5fe08a), contact = Color::hex(0xff4d6d),
                joint = Color::hex(0xf7ef6a), velocity = Color::hex(0xffffff), boxed = Color::hex(0x46d6c8);

Color colorOf(const BodyView& body, bool isSensor) {
    if (isSensor) return sensor;
    if (body.type() == BodyType::Static) return fixed;
    if (!body.awake()) return asleep;
    return body.type() == BodyType::Kinematic ? driven : awake;
}

/// Draws a shape's outline in the frame of its body.
struct Outliner {
    Canvas& canvas;
    Color color;
    double width;

    void operator()(const Circle& c) const {
        canvas.circle(c.center, c.radius, stroke(color, width));
        canvas.line(c.center, c.center + Vec2(c.radius, 0), color, width);
    }
    void operator()(const Capsule& c) const {
        const Vec2 side = c.radius * perp((c.end - c.start).normalized());
        canvas.line(c.start + side, c.end + side, color, width);
        canvas.line(c.start - side, c.end - side, color, width);
        canvas.circle(c.start, c.radius, stroke(color, width));
        canvas.circle(c.end, c.radius, stroke(color, width));
    }
    void operator()(const Polygon& p) const {
        canvas.polygon(p.vertices, stroke(color, width));
        // The outline of a rounded polygon: each edge, shifted by the radius, and a circle at each corner.
        for (std::size_t i = 0; p.radius > 0 && i < p.vertices.size(); ++i) {
            const Vec2& from = p.vertices[i];
            const Vec2& to = p.vertices[(i + 1) % p.vertices.size()];
            const Vec2 out = -p.radius * perp((to - from).normalized());
            canvas.line(from + out, to + out, color, width);
            canvas.circle(from, p.radius, stroke(color.faded(0.4), width));
        }
    }
    void operator()(const Segment& s) const { canvas.line(s.start, s.end, color, 2 * width); }
    void operator()(const Chain& c) const {
        std::vector<Vec2> points = c.points;
        if (c.closed) points.push_back(points.front());
        canvas.polyline(std::move(points), color, 2 * width);
    }
    void operator()(const TileMap& map) const {
        for (int row = 0; row < map.rows(); ++row)
            for (int column = 0; column < map.columns(); ++column) drawTile(map, {column, row});
    }
    void drawTile(const TileMap& map, Cell cell) const {
        const Tile tile = map.at(cell);
        if (isEmpty(tile)) return;
        const Color own = tile.kind == TileKind::Hazard ? contact : tile.kind == TileKind::Sensor ? sensor : color;
        canvas.polygon(map.cornersOf(cell), stroke(own.faded(isSolid(tile) ? 1 : 0.5), width));
    }
};

void drawShapes(Canvas& canvas, const World& world) {
    const double width = 1.5 * canvas.unitsPerPixel();
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        const auto placed = canvas.place({.position = body.position(), .angle = body.angle()});
        for (const ShapeId shape : body.shapes()) {
            const ShapeDef def = world.shape(shape).def();
            std::visit(Outliner{canvas, colorOf(body, def.sensor), width}, def.shape);
        }
    }
}

void drawBoxes(Canvas& canvas, const World& world) {
    for (const BodyId id : world.bodies())
        for (const ShapeId shape : world.body(id).shapes()) {
            const Aabb box = aabbOf(world.shape(shape).def().shape, world.body(id).pose());
            canvas.rect(box.lower, box.upper - box.lower, stroke(boxed.faded(0.5), canvas.unitsPerPixel()));
        }
}

void drawContacts(Canvas& canvas, const World& world) {
    const double pixel = canvas.unitsPerPixel();
    for (const BodyId id : world.bodies())
        for (const Contact& c : world.body(id).contacts()) {
            if (c.shapeA.body != id) continue;  // the other body lists it too
            for (const ContactPoint& p : c.points) {
                // 8 pixels for 1 N, 80 pixels for 1 kN.
                const double length = 8 * pixel * std::log2(1 + p.normalForce);
                canvas.circle(p.position, 3 * pixel, contact);
                canvas.line(p.position, p.position + length * c.normal, contact, 1.5 * pixel);
            }
        }
}

/// Draws lines from body to body, or to the fixed points of a pulley or the target in the world.
void drawJoint(Canvas& canvas, const World& world, const JointDef& def) {
    const double width = 1.5 * canvas.unitsPerPixel();
    const auto at = [&](BodyId body) { return world.body(body).centerOfMass(); };
    const auto link = [&](const Vec2& from, const Vec2& to) {
        canvas.line(from, to, joint, width);
        canvas.circle(from, 2 * width, joint);
        canvas.circle(to, 2 * width, joint);
    };
    if (const auto* pulley = std::get_if<PulleyJointDef>(&def)) {
        link(at(pulley->bodyA), pulley->groundA);
        link(pulley->groundA, pulley->groundB);
        link(pulley->groundB, at(pulley->bodyB));
    } else if (const auto* target = std::get_if<TargetJointDef>(&def)) {
        link(at(target->body), target->target);
    } else {
        std::visit(
            [&](const auto& d) {
                if constexpr (requires { d.bodyA; }) link(at(d.bodyA), at(d.bodyB));
            },
            def);
    }
}

void drawVelocities(Canvas& canvas, const World& world) {
    constexpr double shown = 0.2;  // a line shows the motion in this time [s]
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        if (body.type() == BodyType::Static || body.velocity() == Vec2(0, 0)) continue;
        const Vec2 from = body.centerOfMass();
        canvas.line(from, from + shown * body.velocity(), velocity, 1.5 * canvas.unitsPerPixel());
    }
}

/// Of the dynamic bodies: the kinetic energy, and m g h above the world's origin [J].
std::pair<double, double> energyOf(const World& world) {
    double kinetic = 0, gravitational = 0;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        const double spin = body.angularVelocity();
        kinetic += (body.mass() * body.velocity().squaredNorm() + body.inertia() * spin * spin) / 2;
        gravitational -= body.mass() * body.gravityScale() * world.gravity().dot(body.centerOfMass());
    }
    return {kinetic, gravitational};
}

template <class... Parts>
std::string line(const char* format, Parts... parts) {
    char text[120];
    std::snprintf(text, sizeof text, format, parts...);
    return text;
}

}  // namespace

void drawDebug(Canvas& canvas, const World& world, const DebugView& view) {
    canvas.layer(debugLayer);
    canvas.look(canvas.camera());
    if (view.boxes) drawBoxes(canvas, world);
    if (view.shapes) drawShapes(canvas, world);
    if (view.joints)
        for (const JointId id : world.joints()) drawJoint(canvas, world, world.joint(id).def());
    if (view.contacts) drawContacts(canvas, world);
    if (view.velocities) drawVelocities(canvas, world);
}

FooterLine figuresOf(const World& world) {
    const WorldCounts counts = world.counts();
    const auto [kinetic, gravitational] = energyOf(world);
    return {
        line("%zu bodies, %zu awake", counts.bodies, counts.awakeBodies),
        line("%zu shapes, %zu joints", counts.shapes, counts.joints),
        line("%zu contacts, %zu touch", counts.contacts, counts.touchingContacts),
        line("kinetic %.1f J", kinetic),
        line("gravitational %.1f J", gravitational),
    };
}

}  // namespace plumb::games
