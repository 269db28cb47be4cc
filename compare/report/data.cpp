// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include <compare/metric/conserved.h>
#include <compare/report/curve.h>
#include <compare/report/playback.h>
#include <compare/scene/fields.h>
#include <compare/scene/joint_geometry.h>
#include <plumb/math/transform.h>
#include <plumb/shapes/tile_pieces.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

constexpr std::size_t mostForces = 8;  // the forces of so many joints are kept for the page's CSV

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
json jointData(const SceneJoint& joint, const JointGeometry& geometry) {
    if (geometry.bodyA == noBody) return {};
    json data{{"name", joint.name},
              {"a", geometry.bodyA},
              {"b", geometry.bodyB},
              {"type", tagsOfAlternatives<JointDef>[joint.def.index()]},
              {"atA", pair(geometry.localAnchorA)},
              {"atB", pair(geometry.localAnchorB)}};
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

json partData(const PackedPart& part) {
    return {part.first, part.count};
}

/// Null if the series does not exist or has no numbers.
json curveData(const std::vector<double>& series, std::size_t stride, PackedBlock& block) {
    const bool empty = std::ranges::all_of(series, [](double value) { return std::isnan(value); });
    return empty ? json() : partData(block.addFloats(thinned(series, stride)));
}

json probeData(const Scene& scene, const Observation& run, std::size_t stride, PackedBlock& block) {
    json curves = json::array();
    for (std::size_t p = 0; p < scene.probes.size(); ++p) {
        std::vector<double> series;
        for (const std::vector<double>& tick : run.probes) series.push_back(tick.at(p));
        curves.push_back(curveData(series, stride, block));
    }
    return curves;
}

/// A name and a curve of each kind of energy that the scene has. Potential energy has none: it is what the others leave
/// of the sum. Nothing if the curves do not keep every tick, because then they have peaks of different ticks.
json energiesData(const Series& series, std::size_t stride, PackedBlock& block) {
    json energies = json::array();
    for (std::size_t i = 0; stride == 1 && i < energyKinds.size(); ++i) {
        const auto isNone = [](double energy) { return energy == 0 || std::isnan(energy); };
        if (std::ranges::all_of(series.energies[i], isNone)) continue;
        const bool isRest = energyKinds[i] == std::string_view("potential");
        energies.push_back({energyKinds[i], isRest ? json() : curveData(series.energies[i], stride, block)});
    }
    return energies;
}

/// A name and a curve of each joint's force. Nothing in scenes of many joints, which would take too much room, or if
/// the curves do not keep every tick.
json forcesData(const Scene& scene, const Observation& run, std::size_t stride, PackedBlock& block) {
    json forces = json::array();
    const bool isKnown = !run.jointForces.empty() && !run.jointForces.front().empty();
    if (!isKnown || stride > 1 || scene.joints.size() > mostForces) return forces;
    for (std::size_t joint = 0; joint < scene.joints.size(); ++joint) {
        std::vector<double> series;
        for (const std::vector<double>& tick : run.jointForces) series.push_back(tick.at(joint));
        forces.push_back({scene.joints[joint].name, curveData(series, stride, block)});
    }
    return forces;
}

json engineData(const Scene& scene, const EngineResult& result, const PlaybackFormat& format, std::size_t curveStride,
                PackedBlock& block) {
    const Observation& run = result.observation;
    json settings = json::array();
    for (const Setting& setting : run.settings) settings.push_back({setting.first, setting.second});
    json metrics = json::object();
    for (const auto& [name, value] : result.measured.metrics) metrics[name] = value ? json(*value) : json();
    json data = {{"name", run.engine}, {"version", run.version}, {"settings", settings}, {"metrics", metrics}};
    data["answer"] = result.answer;
    if (!run.unsupported.empty()) {
        data["unsupported"] = run.unsupported;
        return data;
    }
    data["bodies"] = playedBodies(scene, run.role);
    data["ticks"] = playedTicks(scene, run);
    data["states"] = partData(packPlayback(scene, run, format, block));
    data["probes"] = probeData(scene, run, curveStride, block);
    data["error"] = curveData(result.measured.series.error, curveStride, block);
    data["divergence"] = curveData(result.measured.series.divergence, curveStride, block);
    data["energy"] = curveData(result.measured.series.energy, curveStride, block);
    data["energies"] = energiesData(result.measured.series, curveStride, block);
    data["forces"] = forcesData(scene, run, curveStride, block);
    return data;
}

json outcomeData(const Outcome& outcome) {
    return {{"check", outcome.check},   {"engine", outcome.engine},
            {"metric", outcome.metric}, {"value", outcome.value ? json(*outcome.value) : json()},
            {"limit", outcome.limit},   {"pass", outcome.pass},
            {"reason", outcome.reason}};
}

json closedFormData(const Scene& scene) {
    if (!scene.closedForm) return nullptr;
    return {{"formula", scene.closedForm->formula},
            {"source", scene.closedForm->source},
            {"until", scene.closedForm->until}};
}

/// The limits that are shown in the charts.
json limitData(const Scene& scene) {
    json limits = json::object();
    for (const Check& check : scene.checks) {
        if (const auto* exact = std::get_if<ExactCheck>(&check)) limits["error"] = exact->limit;
        if (const auto* agree = std::get_if<AgreeCheck>(&check)) {
            limits["divergence"] = agree->tolerance;
            limits["agreeUntil"] = agree->until;
        }
    }
    return limits;
}

/// body is empty if the two stay together.
json partingData(const Scene& scene, const Parting& parting) {
    return {{"a", parting.engineA},
            {"b", parting.engineB},
            {"body", parting.body},
            {"time", parting.time},
            {"text", partingText(scene, parting)}};
}

json sceneData(const SceneResult& result, const PlaybackFormat& format, const ReportSettings& settings) {
    const Scene& scene = result.scene;
    std::size_t ticks = 1;
    double dt = scene.dt;
    for (const EngineResult& engine : result.engines) {
        if (!engine.observation.unsupported.empty()) continue;
        ticks = std::max(ticks, engine.observation.states.size());
        dt = engine.observation.dt;
    }
    const std::size_t stride = curveStride(ticks, settings.curvePoints);
    json data = {{"name", scene.name},
                 {"title", titleOf(scene)},
                 {"group", scene.group},
                 {"question", scene.question},
                 {"changed", result.changed},
                 {"pass", result.verdict},
                 {"checks", scene.checks.size()},
                 {"dt", dt},
                 {"steps", ticks - 1},
                 {"gravity", pair(scene.gravity)},
                 {"closedForm", closedFormData(scene)},
                 {"limits", limitData(scene)},
                 {"stride", format.stride},
                 {"lengthStep", format.lengthStep},
                 {"angleStep", format.angleStep},
                 {"curveStride", stride}};
    data["notes"] = notesData(result);
    data["conserved"] = conservedMomenta(scene);
    data["partings"] = json::array();
    for (const Parting& parting : result.partings) data["partings"].push_back(partingData(scene, parting));
    if (scene.wrap.any()) data["wrap"] = {scene.wrap.width.value_or(0), scene.wrap.height.value_or(0)};
    for (const char* list : {"bodies", "joints", "fields", "probes", "engines", "outcomes"}) data[list] = json::array();
    for (const SceneBody& body : scene.bodies) data["bodies"].push_back(bodyData(body));
    const std::vector<JointGeometry> joints = jointGeometries(scene);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        json joint = jointData(scene.joints[i], joints[i]);
        if (!joint.is_null()) data["joints"].push_back(std::move(joint));
    }
    for (const SceneField& field : scene.fields) data["fields"].push_back(fieldData(scene, field));
    for (const Probe& probe : scene.probes) {
        data["probes"].push_back({{"name", probe.name}, {"unit", probe.unit}, {"from", probe.from}});
    }
    PackedBlock block;
    for (const EngineResult& engine : result.engines) {
        if (engine.observation.role == Role::Truth && !scene.closedForm) continue;
        data["engines"].push_back(engineData(scene, engine, format, stride, block));
    }
    data["packed"] = block.text();
    for (const Outcome& outcome : result.outcomes) data["outcomes"].push_back(outcomeData(outcome));
    return data;
}

}  // namespace

json reportData(const std::vector<SceneResult>& results, const std::vector<LabResult>& labs,
                const ReportSettings& settings) {
    const std::vector<PlaybackFormat> formats = fitPlayback(results, settings.playbackBudget);
    json scenes = json::array();
    for (std::size_t i = 0; i < results.size(); ++i) scenes.push_back(sceneData(results[i], formats[i], settings));
    return {{"schema", 1}, {"engines", enginesData(results)}, {"scenes", scenes}, {"labs", labsData(labs)}};
}

std::string scriptText(const json& data) {
    const std::string plain = data.dump(-1, ' ', false, json::error_handler_t::replace);
    std::string safe;
    safe.reserve(plain.size());
    for (const char c : plain) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace plumb::compare
