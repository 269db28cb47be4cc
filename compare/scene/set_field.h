// SPDX-License-Identifier: MIT
// How does one field of a scene get another value?
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/scene/json_text.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scene with another value in one field. The value is read and checked in the same way as a file.
/// path: names of fields as in the scene's JSON, with dots between them; for an element of a list, its name or its
/// number from 0. A field that a body does not have is that of all of its shapes, or of their materials; one that a
/// shape does not have is that of its material.
///   "dt", "gravity.1", "bodies.ball.velocity", "bodies.ball.shapes.0.circle.radius", "bodies.ball.friction",
///   "bodies.ball.filter.mask", "bodies.ball.mass"
/// A body's mass may be one number: the densities of its shapes are then scaled so that it has this mass, whatever else
/// of the body is set. If it is given with its inertia, the inertia changes by the same factor.
/// value: a number, a fraction "1/240", numbers with commas for a vector, words with commas for a list of words, true,
/// false, null, a word, or else JSON.
/// "ENGINE:PATH" is the field for one engine alone, see Scene::engines.
/// Throws std::invalid_argument that names the path, the value and what was wanted; for an unknown name, it gives the
/// nearest name and the known ones.
Scene withField(const Scene& scene, const std::string& path, const std::string& value);
Scene withJsonField(const Scene& scene, const std::string& path, const Json& value);

/// The number in a field; of several, such as of a body's shapes, the first one. Throws in the same way, and for a
/// field that is not a number.
double numberAt(const Scene& scene, const std::string& path);

/// The value in a field, as JSON; of several the first one. Throws in the same way.
std::string textAt(const Scene& scene, const std::string& path);

/// A number or a fraction: "0.01", "1/240". None for anything else.
std::optional<double> numberOf(const std::string& text);

struct FieldSetting {
    std::string path, value;
};

/// Reads "bodies.ball.velocity=15,26". Throws std::invalid_argument for a text without a path and a "=".
FieldSetting fieldSettingOf(const std::string& text);

/// Sets one field after the other: if two settings are for the same field, the last one holds. Only what comes of all
/// of them is checked.
Scene withFields(Scene scene, std::span<const FieldSetting> settings);

}  // namespace plumb::compare
