// SPDX-License-Identifier: MIT
#include <compare/scene/set_field.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <compare/scene/body_mass.h>
#include <compare/scene/json_value.h>
#include <compare/scene/named.h>
#include <plumb/math/check.h>

namespace plumb::compare {
namespace {

std::vector<std::string> splitAt(char separator, const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

/// The name of an element of a list: its own name, or the name of the body that its only alternative is about.
std::string nameOfElement(const Json& element) {
    if (!element.is_object()) return {};
    if (const auto name = element.find("name"); name != element.end()) return name->get<std::string>();
    if (element.size() == 1 && element.begin()->is_object() && element.begin()->contains("body"))
        return element.begin()->at("body").get<std::string>();
    return {};
}

std::optional<std::size_t> placeFrom(const std::string& text) {
    std::size_t place = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, place);
    if (error != std::errc{} || rest != end) return {};
    return place;
}

/// where: the path up to the list or object that does not have the name.
[[noreturn]] void refuseStep(const std::string& where, const std::string& name, const std::string& what,
                             const std::vector<std::string>& known) {
    const std::string hint =
        known.empty() ? "it has none" : "the nearest is " + nearest(name, known) + "; known are " + listText(known);
    refuse(where.empty() ? name : where + "." + name, quoted(name) + " is not " + what + ", " + hint);
}

Json& elementOf(Json& list, const std::string& name, const std::string& where) {
    std::vector<std::string> known;
    for (Json& element : list) {
        if (nameOfElement(element) == name && !name.empty()) return element;
        if (const std::string own = nameOfElement(element); !own.empty()) known.push_back(own);
    }
    const std::optional<std::size_t> place = placeFrom(name);
    if (place && *place < list.size()) return list[*place];
    if (place || known.empty())
        refuse(where + "." + name,
               quoted(name) + " is not a place in a list of " + std::to_string(list.size()) + ", which count from 0");
    refuseStep(where, name, "the name of one of them", known);
}

std::vector<std::string> fieldsOf(const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, field] : object.items()) names.push_back(name);
    return names;
}

/// The field of this name in an object; or, if it has none, those in its material and in each of its shapes.
std::vector<Json*> fieldsNamed(const std::string& name, Json& object) {
    if (object.contains(name)) return {&object[name]};
    std::vector<Json*> found;
    if (object.contains("material")) found = fieldsNamed(name, object["material"]);
    if (object.contains("shapes"))
        for (Json& shape : object["shapes"])
            for (Json* field : fieldsNamed(name, shape)) found.push_back(field);
    return found;
}

/// where: the path to the value.
std::vector<Json*> partsOf(Json& value, const std::string& name, const std::string& where) {
    if (value.is_null()) refuse(where, "is not given, wanted all of it at once, as JSON");
    if (!value.is_structured()) refuse(where + "." + name, where + " has no parts: it is " + value.dump());
    if (value.is_array()) return {&elementOf(value, name, where)};
    std::vector<Json*> fields = fieldsNamed(name, value);
    if (fields.empty()) refuseStep(where, name, "a field", fieldsOf(value));
    return fields;
}

/// The values at the path: one value, or one for each shape of a body.
std::vector<Json*> valuesAt(Json& root, const std::string& path) {
    std::vector<Json*> at{&root};
    std::string where;
    for (const std::string& name : splitAt('.', path)) {
        std::vector<Json*> next;
        for (Json* value : at)
            for (Json* part : partsOf(*value, name, where)) next.push_back(part);
        at = std::move(next);
        where += (where.empty() ? "" : ".") + name;
    }
    return at;
}

std::optional<double> plainNumber(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end || !std::isfinite(value)) return {};
    return value;
}

/// A number or a fraction. A number written as a whole number stays a whole number.
std::optional<Json> numberFrom(const std::string& text) {
    if (const std::size_t slash = text.find('/'); slash != std::string::npos) {
        const auto over = plainNumber(text.substr(0, slash)), under = plainNumber(text.substr(slash + 1));
        if (!over || !under) return {};
        if (*under == 0) throw std::invalid_argument(text + " divides by 0");
        return *over / *under;
    }
    if (Json json = Json::parse(text, nullptr, false); json.is_number()) return json;
    if (const std::optional<double> number = plainNumber(text)) return *number;
    return {};
}

std::optional<Json> numbersFrom(const std::string& text) {
    Json list = Json::array();
    for (const std::string& part : splitAt(',', text)) {
        const std::size_t first = std::min(part.find_first_not_of(' '), part.size());
        const std::optional<Json> number = numberFrom(part.substr(first));
        if (!number) return {};
        list.push_back(*number);
    }
    return list;
}

/// text: as on a command line. The present value decides what a word means.
Json valueFrom(const std::string& text, const Json& now) {
    const bool json = text.starts_with('{') || text.starts_with('[') || text.starts_with('"');
    if (json) {
        Json value = Json::parse(text, nullptr, false);
        if (value.is_discarded()) throw std::invalid_argument(quoted(text) + " is not JSON");
        return value;
    }
    if (now.is_string() && !numberFrom(text)) return text;
    if (text == "true" || text == "false" || text == "null") return Json::parse(text);
    if (now.is_array() && !now.empty() && now.front().is_string()) return splitAt(',', text);
    if (const std::optional<Json> number = numberFrom(text)) return *number;
    if (const std::optional<Json> numbers = numbersFrom(text)) return *numbers;
    if (now.is_array() && now.empty()) return splitAt(',', text);
    return text;
}

/// A number for a mass that is given with its inertia changes both by the same factor.
Json inPlaceOf(const Json& now, Json value) {
    const auto has = [&](const char* field) { return now.contains(field) && now[field].is_number(); };
    if (!value.is_number() || !has("mass") || !has("inertia")) return value;
    Json scaled = now;
    scaled["mass"] = value;
    scaled["inertia"] = now["inertia"].get<double>() * value.get<double>() / now["mass"].get<double>();
    return scaled;
}

/// made: takes the present value at the path and gives the new one.
template <class Make>
void setAt(Json& root, const std::string& path, const std::string& shown, const Make& made) {
    try {
        for (Json* place : valuesAt(root, path)) *place = inPlaceOf(*place, made(*place));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path + "=" + shown + ": " + error.what());
    }
}

/// shown: what was set in it.
Scene sceneFrom(const Json& root, const std::string& shown) {
    try {
        return sceneOf(root);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(shown + ": " + error.what());
    }
}

/// With every field that what was set before brings with it; as it is where that is not a scene yet. A mass that is
/// given as a number stays one: it holds whatever else of the body is set after it.
Json completed(const Json& root) {
    try {
        Json whole = jsonOf(sceneOf(root), Defaults::Written), rest = root;
        putMasses(whole, takeMasses(rest));
        return whole;
    } catch (const std::invalid_argument&) {
        return root;
    }
}

}  // namespace

Scene withField(const Scene& scene, const std::string& path, const std::string& value) {
    const FieldSetting setting{path, value};
    return withFields(scene, {&setting, 1});
}

Scene withJsonField(const Scene& scene, const std::string& path, const Json& value) {
    Json root = jsonOf(scene, Defaults::Written);
    setAt(root, path, value.dump(), [&](const Json&) { return value; });
    return sceneFrom(root, path + "=" + value.dump());
}

std::string textAt(const Scene& scene, const std::string& path) {
    Json root = uncheckedJsonOf(scene, Defaults::Written);
    return valuesAt(root, path).front()->dump();
}

namespace {

/// Of "bodies.ball.mass", also where it is that of the shapes; none for another path.
std::optional<double> massAt(const Scene& scene, const std::string& path) {
    const std::string start = "bodies.", end = ".mass";
    if (!path.starts_with(start) || !path.ends_with(end) || path.size() <= start.size() + end.size()) return {};
    const std::string name = path.substr(start.size(), path.size() - start.size() - end.size());
    const auto body = std::ranges::find(scene.bodies, name, &SceneBody::name);
    return body == scene.bodies.end() ? std::nullopt : std::optional(massOf(body->def).mass);
}

/// Of "plumb:solver.subSteps", where the scene sets it.
double engineNumberAt(const Scene& scene, const std::string& path) {
    const std::size_t colon = path.find(':');
    const auto engine = scene.engines.find(path.substr(0, colon));
    const std::string field = path.substr(colon + 1);
    if (engine == scene.engines.end() || !engine->second.contains(field))
        refuse(path, "is not set in the scene, wanted a value for it there");
    const Json value = Json::parse(engine->second.at(field));
    if (!value.is_number()) refuse(path, value.dump() + " is not a number");
    return value.get<double>();
}

}  // namespace

double numberAt(const Scene& scene, const std::string& path) {
    if (const std::optional<double> mass = massAt(scene, path)) return *mass;
    if (path.find(':') != std::string::npos) return engineNumberAt(scene, path);
    Json root = uncheckedJsonOf(scene, Defaults::Written);
    const Json& value = *valuesAt(root, path).front();
    if (!value.is_number()) refuse(path, value.dump() + " is not a number");
    return value.get<double>();
}

std::optional<double> numberOf(const std::string& text) {
    try {
        const std::optional<Json> number = numberFrom(text);
        return number ? std::optional<double>(number->get<double>()) : std::nullopt;
    } catch (const std::invalid_argument&) {
        return {};  // divided by 0
    }
}

FieldSetting fieldSettingOf(const std::string& text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0)
        throw std::invalid_argument(quoted(text) + " is not PATH=VALUE, as bodies.ball.velocity=15,26");
    return {text.substr(0, sign), text.substr(sign + 1)};
}

Scene withFields(Scene scene, std::span<const FieldSetting> settings) {
    std::string shown;
    Json root = jsonOf(scene, Defaults::Written);
    for (const auto& [path, value] : settings) {
        if (const std::size_t colon = path.find(':'); colon != std::string::npos) {
            root["engines"][path.substr(0, colon)][path.substr(colon + 1)] = valueFrom(value, {});
        } else {
            if (!shown.empty()) root = completed(root);
            setAt(root, path, value, [&](const Json& now) { return valueFrom(value, now); });
        }
        shown += (shown.empty() ? "" : " --set ") + path + "=" + value;
    }
    return sceneFrom(root, shown);
}

}  // namespace plumb::compare
