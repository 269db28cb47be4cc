// SPDX-License-Identifier: MIT
// Which functions of a world, and of the views of its objects, does JavaScript have?
// list(class, name, parameters, function): a parameter with ? may be left out, one with = has a default.
#pragma once
#include <plumb/plumb.h>
#include <web/module/call.h>
#include <web/module/formula_calls.h>
#include <web/module/mover_calls.h>
#include <web/module/shape_calls.h>

namespace plumb::web {

void listEditCalls(auto&& list) {
    list("World", "new", "def?", fn<[](const WorldDef& def) { return addressOf(new WorldHost{World(def)}); }>);
    list("World", "copy", "", fn<[](const WorldHost& host) { return addressOf(new WorldHost(host)); }>);
    list("World", "free", "", fn<[](WorldHost& host) { delete &host; }>);
    list("World", "add", "def", fn<[](World& w, const BodyDef& def) { return w.add(def); }>);
    list("World", "add", "body, shape",
         fn<[](World& w, BodyId body, const ShapeDef& shape) { return w.add(body, shape); }>);
    list("World", "join", "def", fn<[](World& w, const JointDef& def) { return w.join(def); }>);
    list("World", "addField", "def", fn<[](World& w, const FieldDef& def) { return w.addField(def); }>);
    list("World", "remove", "body", fn<[](World& w, BodyId id) { w.remove(id); }>);
    list("World", "remove", "shape", fn<[](World& w, ShapeId id) { w.remove(id); }>);
    list("World", "remove", "joint", fn<[](World& w, JointId id) { w.remove(id); }>);
    list("World", "remove", "field", fn<[](World& w, FieldId id) { w.remove(id); }>);
    list("World", "contains", "body", fn<[](const World& w, BodyId id) { return w.contains(id); }>);
    list("World", "contains", "shape", fn<[](const World& w, ShapeId id) { return w.contains(id); }>);
    list("World", "contains", "joint", fn<[](const World& w, JointId id) { return w.contains(id); }>);
    list("World", "contains", "field", fn<[](const World& w, FieldId id) { return w.contains(id); }>);
    list("World", "explode", "explosion, filter?", fn<&World::explode>);
    list("World", "step", "dt", fn<&World::step>);
    list("World", "body", "body", fn<[](World& w, BodyId id) { return w.body(id); }>);
    list("World", "shape", "shape", fn<[](World& w, ShapeId id) { return w.shape(id); }>);
    list("World", "joint", "joint", fn<[](World& w, JointId id) { return w.joint(id); }>);
    list("World", "field", "field", fn<[](World& w, FieldId id) { return w.field(id); }>);
    list("World", "bodies", "", fn<&World::bodies>);
    list("World", "shapes", "", fn<&World::shapes>);
    list("World", "joints", "", fn<&World::joints>);
    list("World", "fields", "", fn<&World::fields>);
    list("World", "tiles", "shape", fn<&World::tiles>);
    list("World", "setTile", "shape, cell, tile", fn<&World::setTile>);
    list("World", "wrap", "", fn<&World::wrap>);
    list("World", "gravity", "", fn<&World::gravity>);
    list("World", "setGravity", "gravity", fn<&World::setGravity>);
    list("World", "ledger", "", fn<&World::ledger>);
    list("World", "reserve", "capacity", fn<&World::reserve>);
    list("World", "counts", "", fn<&World::counts>);
    list("World", "profile", "", fn<&World::profile>);
    list("", "shortest", "wrap, from, to",
         fn<[](const Wrap& wrap, const Vec2& from, const Vec2& to) { return wrap.shortest(from, to); }>);
}

void listQueryCalls(auto&& list) {
    list("World", "castRay", "from, to, filter?, ignored?", fn<&World::castRay>);
    list("World", "castRayAll", "from, to, filter?, ignored?", fn<&World::castRayAll>);
    list("World", "castShape", "shape, pose, shift, filter?, ignored?", fn<&World::castShape>);
    list("World", "castShapeAll", "shape, pose, shift, filter?, ignored?", fn<&World::castShapeAll>);
    list("World", "castShapePieces", "shape, pose, shift, filter?, ignored?", fn<&World::castShapePieces>);
    list("World", "overlapBox", "box, filter?", fn<&World::overlapBox>);
    list("World", "overlapShape", "shape, pose, filter?", fn<&World::overlapShape>);
    list("World", "overlapPoint", "point, filter?", fn<&World::overlapPoint>);
    list("World", "nearest", "point, within = Infinity, filter?", fn<&World::nearest>);
    list("World", "distance", "a, b", fn<&World::distance>);
    list("World", "contactBegins", "", fn<&World::contactBegins>);
    list("World", "contactEnds", "", fn<&World::contactEnds>);
    list("World", "contactHits", "", fn<&World::contactHits>);
    list("World", "sensorBegins", "", fn<&World::sensorBegins>);
    list("World", "sensorEnds", "", fn<&World::sensorEnds>);
    list("World", "jointBreaks", "", fn<&World::jointBreaks>);
    list("World", "quarantines", "", fn<&World::quarantines>);
    list("World", "moves", "", fn<&World::moves>);
    list("", "forecast", "world, body, ticks, dt",
         fn<[](const World& w, BodyId body, int ticks, double dt) { return forecast(w, body, ticks, dt); }>);
    list("", "forecast", "world, shot, ticks, dt",
         fn<[](const World& w, const BodyDef& shot, int ticks, double dt) { return forecast(w, shot, ticks, dt); }>);
    list("", "stateHash", "world", fn<&stateHash>);
}

void listBodyCalls(auto&& list) {
    list("Body", "type", "", fn<&BodyView::type>);
    list("Body", "position", "", fn<&BodyView::position>);
    list("Body", "angle", "", fn<&BodyView::angle>);
    list("Body", "pose", "", fn<&BodyView::pose>);
    list("Body", "centerOfMass", "", fn<&BodyView::centerOfMass>);
    list("Body", "velocity", "", fn<&BodyView::velocity>);
    list("Body", "angularVelocity", "", fn<&BodyView::angularVelocity>);
    list("Body", "velocityAt", "point", fn<&BodyView::velocityAt>);
    list("Body", "mass", "", fn<&BodyView::mass>);
    list("Body", "inertia", "", fn<&BodyView::inertia>);
    list("Body", "gravityScale", "", fn<&BodyView::gravityScale>);
    list("Body", "linearDamping", "", fn<&BodyView::linearDamping>);
    list("Body", "angularDamping", "", fn<&BodyView::angularDamping>);
    list("Body", "awake", "", fn<&BodyView::awake>);
    list("Body", "enabled", "", fn<&BodyView::enabled>);
    list("Body", "quarantined", "", fn<&BodyView::quarantined>);
    list("Body", "tag", "", fn<&BodyView::tag>);
    list("Body", "shapes", "", fn<&BodyView::shapes>);
    list("Body", "joints", "", fn<&BodyView::joints>);
    list("Body", "contacts", "", fn<&BodyView::contacts>);
    list("Body", "setVelocity", "velocity", fn<&Body::setVelocity>);
    list("Body", "setAngularVelocity", "angularVelocity", fn<&Body::setAngularVelocity>);
    list("Body", "setPose", "position, angle", fn<&Body::setPose>);
    list("Body", "moveTo", "position, angle, dt", fn<&Body::moveTo>);
    list("Body", "applyForce", "force", fn<[](Body& b, const Vec2& force) { b.applyForce(force); }>);
    list("Body", "applyForce", "force, at",
         fn<[](Body& b, const Vec2& force, const Vec2& at) { b.applyForce(force, at); }>);
    list("Body", "applyTorque", "torque", fn<&Body::applyTorque>);
    list("Body", "applyImpulse", "impulse", fn<[](Body& b, const Vec2& impulse) { b.applyImpulse(impulse); }>);
    list("Body", "applyImpulse", "impulse, at",
         fn<[](Body& b, const Vec2& impulse, const Vec2& at) { b.applyImpulse(impulse, at); }>);
    list("Body", "applyAngularImpulse", "impulse", fn<&Body::applyAngularImpulse>);
    list("Body", "setType", "type", fn<&Body::setType>);
    list("Body", "setMass", "mass", fn<&Body::setMass>);
    list("Body", "setMassFromShapes", "", fn<&Body::setMassFromShapes>);
    list("Body", "setGravityScale", "scale", fn<&Body::setGravityScale>);
    list("Body", "setLinearDamping", "damping", fn<&Body::setLinearDamping>);
    list("Body", "setAngularDamping", "damping", fn<&Body::setAngularDamping>);
    list("Body", "setFixedRotation", "fixed", fn<&Body::setFixedRotation>);
    list("Body", "setLocks", "lockX, lockY", fn<&Body::setLocks>);
    list("Body", "setCanSleep", "canSleep", fn<&Body::setCanSleep>);
    list("Body", "wake", "", fn<&Body::wake>);
    list("Body", "sleep", "", fn<&Body::sleep>);
    list("Body", "setEnabled", "enabled", fn<&Body::setEnabled>);
    list("Body", "setTag", "tag", fn<&Body::setTag>);
}

void listOtherViewCalls(auto&& list) {
    list("BodyShape", "body", "", fn<&BodyShapeView::body>);
    list("BodyShape", "def", "", fn<&BodyShapeView::def>);
    list("BodyShape", "sensor", "", fn<&BodyShapeView::sensor>);
    list("BodyShape", "material", "", fn<&BodyShapeView::material>);
    list("BodyShape", "filter", "", fn<&BodyShapeView::filter>);
    list("BodyShape", "tag", "", fn<&BodyShapeView::tag>);
    list("BodyShape", "set", "def", fn<&BodyShape::set>);
    list("BodyShape", "setMaterial", "material", fn<&BodyShape::setMaterial>);
    list("BodyShape", "setFilter", "filter", fn<&BodyShape::setFilter>);
    list("BodyShape", "setTag", "tag", fn<&BodyShape::setTag>);
    list("Joint", "def", "", fn<&JointView::def>);
    list("Joint", "reaction", "", fn<&JointView::reaction>);
    list("Joint", "coordinate", "", fn<&JointView::coordinate>);
    list("Joint", "error", "", fn<&JointView::error>);
    list("Joint", "angleError", "", fn<&JointView::angleError>);
    list("Joint", "set", "def", fn<&Joint::set>);
    list("Joint", "setMotorSpeed", "speed", fn<&Joint::setMotorSpeed>);
    list("Field", "def", "", fn<&FieldView::def>);
    list("Field", "set", "def", fn<&Field::set>);
}

/// All functions that JavaScript has, in the order of their numbers.
void listAllCalls(auto&& list) {
    listEditCalls(list);
    listQueryCalls(list);
    listBodyCalls(list);
    listOtherViewCalls(list);
    listShapeCalls(list);
    listGridCalls(list);
    listPlatformCalls(list);
    listPathCalls(list);
    listClockCalls(list);
    listBallisticsCalls(list);
    listKinematicsCalls(list);
    listSteeringCalls(list);
}

}  // namespace plumb::web
