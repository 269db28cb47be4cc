// SPDX-License-Identifier: MIT
// How does a body get a mass that is given as one number?
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <compare/scene/json_text.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// The mass of a body that a scene's JSON gives as a number, "mass": 3.
struct GivenMass {
    std::size_t body;  ///< its place in the scene
    Json mass;         ///< [kg]
};

/// Takes these numbers out of the JSON of a scene. Throws std::invalid_argument for a mass that is neither a number,
/// nor an object, nor null.
std::vector<GivenMass> takeMasses(Json& scene);

/// Puts them back.
void putMasses(Json& scene, const std::vector<GivenMass>& masses);

/// Scales the densities of all shapes of a valid body, so that they have this mass together [kg]: their centre of mass
/// stays, and the inertia grows with the mass.
/// field: its name in messages. Throws std::invalid_argument unless the mass is positive and finite, and the body
/// dynamic.
void giveMass(BodyDef& def, double mass, const std::string& field);

}  // namespace plumb::compare
