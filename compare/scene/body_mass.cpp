// SPDX-License-Identifier: MIT
#include <compare/scene/body_mass.h>

#include <utility>

#include <compare/scene/json_plain.h>
#include <compare/scene/named.h>
#include <plumb/dynamics/describe.h>
#include <plumb/math/check.h>

namespace plumb::compare {

std::vector<GivenMass> takeMasses(Json& scene) {
    std::vector<GivenMass> taken;
    if (!scene.is_object() || !scene.contains("bodies") || !scene["bodies"].is_array()) return taken;
    Json& bodies = scene["bodies"];
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].is_object() || !bodies[i].contains("mass")) continue;
        Json& mass = bodies[i]["mass"];
        if (mass.is_object() || mass.is_null()) continue;
        if (!mass.is_number()) refuseKind(at("bodies", i) + ".mass", mass, "a number or an object");
        taken.push_back({i, std::exchange(mass, nullptr)});
    }
    return taken;
}

void putMasses(Json& scene, const std::vector<GivenMass>& masses) {
    for (const auto& [body, mass] : masses) scene["bodies"][body]["mass"] = mass;
}

void giveMass(BodyDef& def, double mass, const std::string& field) {
    requirePositive(mass, field);
    if (def.type != BodyType::Dynamic)
        refuse(field, toText(mass) + " is the mass of a " + bodyTypeTags[static_cast<std::size_t>(def.type)] +
                          " body, wanted a dynamic body, or no mass");
    const double factor = mass / massOf(def).mass;
    for (ShapeDef& shape : def.shapes) shape.material.density *= factor;
}

}  // namespace plumb::compare
