// SPDX-License-Identifier: MIT
// Which outline and material does a part of a body have, and what does it collide with?
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <plumb/shapes/hull.h>

namespace plumb {

/// How the coefficients of two materials are combined. Where the two name different rules, the one listed later here is
/// used.
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
    double restitution = 0;                ///< 0 to 1; for bumpers see dynamics/events.md [-]
    double rollingResistance = 0;          ///< torque / (radius normal force), >= 0; a pair has the larger [-]
    double surfaceSpeed = 0;               ///< of a belt: clockwise around the outline, so the top runs to +x [m/s]
    Mix frictionMix = Mix::GeometricMean;  ///< how a pair's friction comes from both
    Mix restitutionMix = Mix::Maximum;     ///< how a pair's restitution comes from both
    friend bool operator==(const Material&, const Material&) = default;
};

/// Two shapes collide when the category of each is in the mask of the other. Shapes of one group other than 0 always
/// collide when it is positive, and never when it is negative.
struct Filter {
    std::uint64_t category = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    int group = 0;
    friend bool operator==(const Filter&, const Filter&) = default;
};

/// A possible contact: what a contact rule can decide by, when another shape is about to touch its own.
struct ContactCandidate {
    Vec2 normal{0, 1};       ///< from the rule's own shape to the other, in the world [-]
    Vec2 localNormal{0, 1};  ///< the same in the frame of the own body [-]
    Vec2 velocity{0, 0};     ///< of the other shape relative to the own one, at the contact, in the world [m/s]
    double separation = 0;   ///< negative when they overlap [m]
    std::uint64_t tag = 0;   ///< of the own shape
    std::uint64_t otherTag = 0;
};

/// May the two shapes touch? Called when they are so near that they may touch within the step; the answer holds until
/// they have separated. Must be a pure function of its argument: the order of the calls is not defined, and a world can
/// be reproduced only if the answers are the same.
using ContactRule = bool (*)(const ContactCandidate&);

struct ShapeDef {
    Shape shape = Circle{};
    Material material{};
    Filter filter{};
    bool sensor = false;  ///< has no contacts, but reports what overlaps it; its density counts towards the mass
    /// Solid only to shapes that come from this side, within 60 degrees (30 at the free end of a line), and that
    /// overlap by 5 mm at most. A shape that was on it stays until it slides off. In the body's frame, not 0 [-]
    std::optional<Vec2> oneWay = std::nullopt;
    ContactRule rule = nullptr;  ///< without one, it touches whatever its filter allows
    std::uint64_t tag = 0;       ///< free for the user
};

/// A disc; its centre is at the origin of the body's frame.
ShapeDef circle(double radius, const Material& material = {});
/// All points within radius of a line.
ShapeDef capsule(const Vec2& start, const Vec2& end, double radius, const Material& material = {});
/// An axis-aligned rectangle around the body's origin; halfSize is half its width and half its height [m].
ShapeDef box(const Vec2& halfSize, const Material& material = {});
ShapeDef box(double, double, const Material& = {}) = delete;  // both in braces: box({halfWidth, halfHeight})
/// The same, with an outline that is offset outwards by radius: halfSize + radius in all.
ShapeDef roundedBox(const Vec2& halfSize, double radius, const Material& material = {});
/// A convex polygon, corners counter-clockwise. For the hull of any points: {.shape = hullOf(points)}.
ShapeDef polygon(std::vector<Vec2> vertices, const Material& material = {});
/// A convex polygon whose outline is offset outwards by radius from its corners and edges.
ShapeDef roundedPolygon(std::vector<Vec2> vertices, double radius, const Material& material = {});
/// A line, solid from both sides.
ShapeDef segment(const Vec2& start, const Vec2& end, const Material& material = {});
/// A line through points, smooth to slide along, solid from both sides.
ShapeDef chain(std::vector<Vec2> points, const Material& material = {});
/// The same, closed: the last point is connected to the first.
ShapeDef loop(std::vector<Vec2> points, const Material& material = {});

/// A tile map with its lower left corner at the body's origin.
ShapeDef tiles(TileMap map, const Material& material = {});

/// A simple polygon, convex or not, of either orientation, split into as many convex polygons as it takes: use as
/// BodyDef.shapes. See shapes/decompose.h for what is refused.
std::vector<ShapeDef> outline(std::vector<Vec2> points, const Material& material = {});

/// Throws std::invalid_argument with the field, the value and what was expected; field is the name of the def itself.
void validate(const ShapeDef& def, const std::string& field);

}  // namespace plumb
