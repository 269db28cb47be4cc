// SPDX-License-Identifier: MIT
#include <compare/scene/random/bodies.h>

#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

/// The largest number of corners at which each corner is at least 1.2 cm above the line through its neighbours,
/// whatever is drawn. Box2D 3 treats corners within 1 cm of that line as on it.
int mostCorners(double radius) {
    if (radius < 0.11) return 5;
    if (radius < 0.15) return 6;
    return radius < 0.2 ? 7 : 8;
}

std::vector<Vec2> regular(int corners, double radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const SinCos at = sinCos(fullTurn * i / corners);
        points.push_back(radius * Vec2(at.cos, at.sin));
    }
    return points;
}

/// Corners on an ellipse: the polygon is convex wherever they lie on it.
std::vector<Vec2> irregular(Draw& draw, int corners, double radius) {
    const double flat = draw.uniform(0.6, 1);
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const double shift = draw.uniform(-0.2, 0.2);
        const SinCos at = sinCos(fullTurn * (i + shift) / corners);
        points.push_back(radius * Vec2(at.cos, flat * at.sin));
    }
    return points;
}

ShapeDef drawRounded(Draw& draw, double radius, const Material& material) {
    const double rounding = radius * draw.uniform(0.1, 0.35), core = radius - rounding;
    if (core < 0.1) return roundedPolygon(regular(draw.integer(3, 4), core), rounding, material);
    const int corners = draw.integer(3, mostCorners(core));
    return roundedPolygon(irregular(draw, corners, core), rounding, material);
}

ShapeDef drawShape(Draw& draw, Form form, double radius, const Material& material) {
    switch (form) {
        case Form::Capsule: {
            const double thickness = radius * draw.uniform(0.25, 0.7), half = radius - thickness;
            return capsule({-half, 0}, {half, 0}, thickness, material);
        }
        case Form::Box: {
            const SinCos corner = sinCos(draw.uniform(0.2, fullTurn / 8));
            return box(radius * Vec2(corner.cos, corner.sin), material);
        }
        case Form::Regular: {
            const int corners = draw.integer(3, mostCorners(radius));
            return polygon(regular(corners, radius), material);
        }
        case Form::Irregular: {
            const int corners = draw.integer(3, mostCorners(radius));
            return polygon(irregular(draw, corners, radius), material);
        }
        case Form::Rounded: return drawRounded(draw, radius, material);
        default: return circle(radius, material);
    }
}

}  // namespace

std::vector<ShapeDef> drawShapes(Draw& draw, Form form, double radius, const Material& material) {
    if (form == Form::Compound) return drawCompound(draw, radius, material);
    return {drawShape(draw, form, radius, material)};
}

Item drawBody(Draw& draw, const Style& style) {
    const double radius = drawRadius(draw, style);
    const Material material = drawMaterial(draw, style);
    const int form = draw.integer(0, static_cast<int>(style.forms.size()) - 1);
    BodyDef def;
    def.shapes = drawShapes(draw, style.forms[static_cast<std::size_t>(form)], radius, material);
    if (!style.upright) def.angle = draw.uniform(-fullTurn / 2, fullTurn / 2);
    if (style.speed > 0) {
        const double speed = draw.uniform(0, style.speed);
        def.velocity = speed * draw.direction();
    }
    if (style.spin > 0) def.angularVelocity = draw.uniform(-style.spin, style.spin);
    return {.bodies = {{"body", def}}, .half = {radius, radius}};
}

}  // namespace plumb::compare
