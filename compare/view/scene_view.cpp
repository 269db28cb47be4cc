// SPDX-License-Identifier: MIT
#include <compare/view/scene_view.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include <compare/metric/conserved.h>
#include <compare/scene/fields.h>
#include <compare/scene/joint_geometry.h>
#include <plumb/math/transform.h>
#include <plumb/shapes/tile_pieces.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

json pair(const Vec2& v) {
    return {v.x(), v.y()};
}

json pointData(const std::vector<Vec2>& points) {
    json data = json::array();
    for (const Vec2& point : points) {
        data.push_back(point.x());
        data.push_back(point.y());
    }
    return data;
}

/// A shape as the page draws it: under its kind the numbers of its points, and the radius around them if it has one.
json shapeData(const Circle& circle) {
    return {{"circle", {circle.center.x(), circle.center.y(), circle.radius}}};
}

json shapeData(const Capsule& capsule) {
    return {{"capsule", pointData({capsule.start, capsule.end})}, {"radius", capsule.radius}};
}

json shapeData(const Polygon& polygon) {
    json data = {{"polygon", pointData(polygon.vertices)}};
    if (polygon.radius > 0) data["radius"] = polygon.radius;
    return data;
}

json shapeData(const Segment& segment) {
    return {{"segment", pointData({segment.start, segment.end})}};
}

/// A ring returns to its first point.
json shapeData(const Chain& chain) {
    std::vector<Vec2> points = chain.points;
    if (chain.closed) points.push_back(chain.points.front());
    return {{"chain", pointData(points)}};
}

/// The areas that the tiles fill, and their outline, each with the kind of its tiles.
json shapesData(const TileMap& map) {
    constexpr const char* kinds[] = {"solid", "oneWay", "hazard", "sensor"};  // in the order of TileKind
    json shapes = json::array();
    for (const TilePiece& piece : tilePiecesOf(map)) {
        const auto* edge = std::get_if<Segment>(&piece.shape);
        shapes.push_back(edge != nullptr ? shapeData(*edge) : shapeData(std::get<Polygon>(piece.shape)));
        shapes.back()["tiles"] = kinds[static_cast<int>(piece.kind)];
    }
    return shapes;
}

json shapesData(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return json::array({shapeData(*circle)});
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return json::array({shapeData(*capsule)});
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return json::array({shapeData(*polygon)});
    if (const auto* segment = std::get_if<Segment>(&shape)) return json::array({shapeData(*segment)});
    if (const auto* chain = std::get_if<Chain>(&shape)) return json::array({shapeData(*chain)});
    return shapesData(std::get<TileMap>(shape));
}

json bodyData(const SceneBody& body) {
    json shapes = json::array();
    for (const ShapeDef& shape : body.def.shapes)
        for (json& data : shapesData(shape.shape)) shapes.push_back(std::move(data));
    json data = {{"name", body.name},
                 {"type", bodyTypeTags[static_cast<std::size_t>(body.def.type)]},
                 {"start", {body.def.position.x(), body.def.position.y(), body.def.angle}},
                 {"shapes", shapes}};
    if (body.def.type == BodyType::Dynamic) data["mass"] = massOf(body.def).mass;
    return data;
}

/// A joint as two bodies and a point fixed to each: the page draws it wherever the bodies are. Null for a gear, which
/// has no place of its own, and for a target, which has one body.
json jointData(std::size_t index, const SceneJoint& joint, const JointGeometry& geometry) {
    if (geometry.bodyA == noBody) return {};
    json data{{"name", joint.name},
              {"index", index},
              {"a", geometry.bodyA},
              {"b", geometry.bodyB},
              {"type", tagsOfAlternatives<JointDef>[joint.def.index()]},
              {"atA", pair(geometry.localAnchorA)},
              {"atB", pair(geometry.localAnchorB)}};
    if (const auto* rod = std::get_if<DistanceJointDef>(&joint.def)) data["spring"] = rod->spring.has_value();
    if (const auto* pulley = std::get_if<PulleyJointDef>(&joint.def))
        data["over"] = {pair(pulley->groundA), pair(pulley->groundB)};
    return data;
}

/// The parts of a field that can be drawn: the surface of water and the direction of its gravity, or the point that
/// attracts. The point of a magnet is in the frame of the body that carries it.
json fieldData(const Scene& scene, const SceneField& field) {
    json data{{"name", field.name}};
    if (const auto* pool = std::get_if<Pool>(&field.def.law)) {
        data["surface"] = pair(pool->fluid.surface);
        data["down"] = pair(pool->fluid.gravity.normalized());
    }
    if (const auto* attractor = std::get_if<Attractor>(&field.def.law)) data["center"] = pair(attractor->center);
    if (const auto* magnet = std::get_if<Magnet>(&field.def.law)) {
        data["center"] = pair(magnet->pull.center);
        data["body"] = bodyIndex(scene, field.body);
    }
    return data;
}

json closedFormData(const Scene& scene) {
    if (!scene.closedForm) return nullptr;
    return {{"formula", scene.closedForm->formula},
            {"source", scene.closedForm->source},
            {"until", scene.closedForm->until}};
}

bool isOfClosedForm(const Scene& scene, const std::string& body) {
    if (!scene.closedForm) return false;
    return std::ranges::any_of(scene.closedForm->bodies, [&](const BodyMotion& motion) {
        return std::visit([&](const auto& m) { return m.body == body; }, motion);
    });
}

}  // namespace

json sceneView(const Scene& scene) {
    json data = {{"name", scene.name},
                 {"title", titleOf(scene)},
                 {"group", scene.group},
                 {"question", scene.question},
                 {"gravity", pair(scene.gravity)},
                 {"closedForm", closedFormData(scene)},
                 {"conserved", conservedMomenta(scene)}};
    if (scene.wrap.any()) data["wrap"] = {scene.wrap.width.value_or(0), scene.wrap.height.value_or(0)};
    for (const char* list : {"bodies", "joints", "fields", "probes"}) data[list] = json::array();
    for (const SceneBody& body : scene.bodies) data["bodies"].push_back(bodyData(body));
    const std::vector<JointGeometry> joints = jointGeometries(scene);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        json joint = jointData(i, scene.joints[i], joints[i]);
        if (!joint.is_null()) data["joints"].push_back(std::move(joint));
    }
    for (const SceneField& field : scene.fields) data["fields"].push_back(fieldData(scene, field));
    for (const Probe& probe : scene.probes)
        data["probes"].push_back({{"name", probe.name}, {"unit", probe.unit}, {"from", probe.from}});
    return data;
}

std::vector<std::size_t> movingBodies(const Scene& scene, Role role) {
    std::vector<std::size_t> played;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        if (body.def.type == BodyType::Static) continue;
        if (role == Role::Truth && !isOfClosedForm(scene, body.name)) continue;
        played.push_back(i);
    }
    return played;
}

}  // namespace plumb::compare
