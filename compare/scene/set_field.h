// SPDX-License-Identifier: MIT
// How is one field of a scene given another value?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/scene/json_text.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scene with another value in one field, read and checked as a file would be.
/// path: names of fields as in the scene's JSON, with dots between them; of a list, the name of an element or its
/// number from 0. A body's density, friction, restitution and what else its shapes' materials have is that of all of
/// its shapes, and a shape's that of its material.
///   "dt", "gravity.1", "bodies.ball.velocity", "bodies.ball.shapes.0.circle.radius", "bodies.ball.friction"
/// value: a number, a fraction "1/240", numbers with commas for a vector or words for a list of words, true, false,
/// null, a word, or else JSON.
/// "ENGINE:PATH" is the field for one engine alone, see Scene::engines.
/// Throws std::invalid_argument that names the path, the value and what was wanted; of an unknown name, the nearest and
/// those that are known.
Scene withField(const Scene& scene, const std::string& path, const std::string& value);
Scene withJsonField(const Scene& scene, const std::string& path, const Json& value);

struct FieldSetting {
    std::string path, value;
};

/// Of "bodies.ball.velocity=15,26". Throws std::invalid_argument for a text without a path and a "=".
FieldSetting fieldSettingOf(const std::string& text);

/// One after the other: where two set the same, the last holds.
Scene withFields(Scene scene, std::span<const FieldSetting> settings);

}  // namespace plumb::compare
