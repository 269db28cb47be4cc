// SPDX-License-Identifier: MIT
#include <compare/scene/json.h>

#include <algorithm>
#include <stdexcept>

#include <compare/scene/body_mass.h>
#include <compare/scene/json_reader.h>
#include <compare/scene/json_value.h>
#include <compare/scene/named.h>

namespace plumb::compare {

/// Fields of a material are often written into the body or the shape itself.
std::string hintForField(const std::string& name, const std::vector<std::string>& known) {
    bool isOfMaterial = false;
    const Material material;
    describe(material, [&](const Member& member, const auto&) { isOfMaterial = isOfMaterial || name == member.name; });
    for (const char* owner : {"shapes", "material"})
        if (isOfMaterial && std::ranges::find(known, owner) != known.end())
            return "it belongs to the material of a shape: " +
                   (owner == std::string("shapes") ? std::string("shapes[0].material.") : std::string("material.")) +
                   name;
    return "the nearest known one is " + nearest(name, known) + "; known are " + listText(known);
}

std::string withLine(const JsonText& text, const std::string& file, const std::string& message) {
    std::string path = message.substr(0, message.find(": "));
    while (!text.lines.contains(path) && !path.empty()) {
        const auto cut = path.find_last_of(".[");
        path = cut == std::string::npos ? std::string() : path.substr(0, cut);
    }
    return file + ":" + std::to_string(text.lines.at(path)) + ": " + onOneLine(message);
}

Scene sceneOf(const Json& value) {
    Json plain = value;
    const std::vector<GivenMass> masses = takeMasses(plain);
    Scene scene = JsonReader::read(JsonType<Scene>(), plain, "");
    validate(scene);
    for (const auto& [body, mass] : masses)
        giveMass(scene.bodies[body].def, mass.get<double>(), at("bodies", body) + ".mass");
    if (!masses.empty()) validate(scene);
    return scene;
}

Scene fromJson(std::string_view text, const std::string& file) {
    const JsonText json = parseJson(text, file);
    try {
        return sceneOf(json.root);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(withLine(json, file, error.what()));
    }
}

}  // namespace plumb::compare
