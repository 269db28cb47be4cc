// SPDX-License-Identifier: MIT
// What is a body's outline made of, and what does it collide with?
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <plumb/shapes/hull.h>

namespace plumb {

/// How two materials' coefficients make one for the pair. Where the two name different rules, the later one here holds.
enum class Mix {
    Average,        ///< (a + b) / 2
    GeometricMean,  ///< sqrt(a b)
    Minimum,
    Product,
    Maximum,
};

struct Material {
    double density = 1;                    ///< >= 0 [kg/m^2]
    double friction = 0.6;                 ///< Coulomb coefficient, >= 0 [-]
    double restitution = 0;                ///< 0 to 1 [-]
    double rollingResistance = 0;          ///< torque over (radius times normal force), >= 0; a pair has the larger [-]
    double surfaceSpeed = 0;               ///< of a belt: clockwise around the outline, so its top runs to +x [m/s]
    Mix frictionMix = Mix::GeometricMean;  ///< how a pair's friction comes from both
    Mix restitutionMix = Mix::Maximum;     ///< how a pair's restitution comes from both
    friend bool operator==(const Material&, const Material&) = default;
};

/// Two shapes collide when each one's category is in the other's mask; but of one group other than 0, always when it
/// is positive and never when it is negative.
struct Filter {
    std::uint64_t category = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    int group = 0;
    friend bool operator==(const Filter&, const Filter&) = default;
};

/// What a contact rule may go by, when another shape comes to touch its own.
struct ContactQuestion {
    Vec2 normal{0, 1};       ///< from its own shape to the other, in the world [-]
    Vec2 localNormal{0, 1};  ///< the same in the frame of its own body [-]
    Vec2 velocity{0, 0};     ///< of the other against its own, where they meet, in the world [m/s]
    double separation = 0;   ///< negative when they overlap [m]
    std::uint64_t tag = 0;   ///< of its own shape
    std::uint64_t otherTag = 0;
};

/// May the two touch? Asked when they have come so near that they may touch within the step; the answer holds until
/// they have parted. A pure function of what it is given: it is asked in no order that is promised, and its answers are
/// part of what makes a world the same again.
using ContactRule = bool (*)(const ContactQuestion&);

struct ShapeDef {
    Shape shape = Circle{};
    Material material{};
    Filter filter{};
    bool sensor = false;  ///< touches nothing, and tells what overlaps it; weighs what its density says
    /// Solid only to what comes from there, within 60 degrees (30 at a line's free end), and overlaps by 5 mm at most;
    /// what was on it stays until it slides off. In the body's frame, not 0 [-]
    std::optional<Vec2> oneWay = std::nullopt;
    ContactRule rule = nullptr;  ///< without one, it touches whatever its filter lets
    std::uint64_t tag = 0;       ///< whatever its owner wants to know it by
};

/// A disc around a point of the body's frame.
ShapeDef circle(double radius, const Material& material = {});
/// All that is within radius of a line.
ShapeDef capsule(const Vec2& start, const Vec2& end, double radius, const Material& material = {});
/// An upright rectangle around the body's origin; halfSize is half its width and half its height [m].
ShapeDef box(const Vec2& halfSize, const Material& material = {});
/// The same, its outline radius outside of what halfSize gives: halfSize + radius in all.
ShapeDef roundedBox(const Vec2& halfSize, double radius, const Material& material = {});
/// A convex polygon, corners counter-clockwise. Of any points: {.shape = hullOf(points)}.
ShapeDef polygon(std::vector<Vec2> vertices, const Material& material = {});
/// A convex polygon whose outline lies radius outside of its corners and edges.
ShapeDef roundedPolygon(std::vector<Vec2> vertices, double radius, const Material& material = {});
/// A line, solid from both sides.
ShapeDef segment(const Vec2& start, const Vec2& end, const Material& material = {});
/// A line through points, smooth to slide along, solid from both sides.
ShapeDef chain(std::vector<Vec2> points, const Material& material = {});
/// The same, closed: from the last point on to the first.
ShapeDef loop(std::vector<Vec2> points, const Material& material = {});

/// A tile map, its lower left corner at the body's origin.
ShapeDef tiles(TileMap map, const Material& material = {});

/// A simple outline, convex or not, either way round, in as many convex polygons as it takes: BodyDef.shapes of it. See
/// shapes/decompose.h for what it refuses.
std::vector<ShapeDef> outline(std::vector<Vec2> points, const Material& material = {});

/// Throws std::invalid_argument naming the field, the value and what was wanted; field is the name of the def itself.
void validate(const ShapeDef& def, const std::string& field);

}  // namespace plumb
