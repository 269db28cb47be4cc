// SPDX-License-Identifier: MIT
#include <compare/scene/schema/schema.h>

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <compare/scene/json_plain.h>
#include <compare/scene/schema/parts.h>
#include <compare/scene/schema/value.h>

namespace plumb::compare {
namespace {

/// Says which overload is meant, if nothing else does.
template <class T>
using SchemaType = std::type_identity<T>;

/// Makes the schemas of values. The schema of a part is written once, under the part's name.
class Schemas {
public:
    Json definitions = Json::object();

    static Json of(SchemaType<double>, const Field& field) { return numberSchema(field.allowed); }
    static Json of(SchemaType<Vec2>, const Field& field) { return vectorSchema(field.allowed); }
    static Json of(SchemaType<bool>, const Field&) { return {{"type", "boolean"}}; }
    static Json of(SchemaType<Lock>, const Field&) { return {{"type", "boolean"}}; }
    static Json of(SchemaType<int>, const Field&) { return signed32Schema(); }
    static Json of(SchemaType<std::uint64_t>, const Field&) { return unsigned64Schema(); }
    static Json of(SchemaType<std::string>, const Field& field) {
        Json text{{"type", "string"}};
        if (field.least > 0) text["minLength"] = field.least;
        return text;
    }
    template <class E>
    requires std::is_enum_v<E>
    static Json of(SchemaType<E>, const Field&) {
        Json tags = Json::array();
        for (const char* tag : tagsOf(E{})) tags.push_back(tag);
        return {{"enum", tags}};
    }
    Json of(SchemaType<TileMap>, const Field& field) { return of(SchemaType<TilesFields>(), field); }
    static Json of(SchemaType<EngineSettings>, const Field&) {
        return {{"type", "object"}, {"additionalProperties", Json{{"type", "object"}}}};
    }
    template <class T>
    Json of(SchemaType<std::optional<T>>, const Field& field) {
        return {{"anyOf", Json::array({of(SchemaType<T>(), field), Json{{"type", "null"}}})}};
    }
    template <class T>
    Json of(SchemaType<std::vector<T>>, const Field& field) {
        const Field one{field.name, field.unit, field.allowed, field.meaning};
        Json list{{"type", "array"}, {"items", of(SchemaType<T>(), one)}};
        if (field.least > 0) list["minItems"] = field.least;
        return list;
    }
    /// A part, that is a type with fields.
    template <class T>
    requires(!std::is_enum_v<T>) Json of(SchemaType<T>, const Field&);
};

/// A visitor of the fields of one part.
class ObjectSchema {
public:
    explicit ObjectSchema(Schemas& schemas) : schemas_(schemas) {}

    template <class T>
    void operator()(const Field& field, const T& value) {
        Json schema = schemas_.of(SchemaType<T>(), field);
        addMeaning(schema, field);
        if (field.needed)
            required_.push_back(field.name);
        else
            addDefault(schema, value);
        properties_[field.name] = std::move(schema);
    }
    void orInfinite(const Field& field, double value) {
        Json schema = numberSchema(field.allowed);
        addMeaning(schema, field);
        schema["default"] = numberOrWord(value);
        properties_[field.name] = std::move(schema);
    }
    void shape(const Shape& shape) {
        oneOf(shape, tagsOfAlternatives<Shape>);
        addAlternative<BoxFields>("box");
    }
    template <class... T>
    void oneOf(const std::variant<T...>&, std::span<const char* const> tags) {
        std::size_t next = 0;
        (addAlternative<T>(tags[next++]), ...);
    }

    Json made(const char* meaning) const {
        Json object{{"type", "object"}};
        if (meaning[0] != '\0') object["description"] = meaning;
        object["properties"] = properties_;
        if (!required_.empty()) object["required"] = required_;
        if (!kinds_.empty()) object["oneOf"] = kinds_;
        object["additionalProperties"] = false;
        return object;
    }

private:
    // The fields of a part give their own defaults.
    template <class T>
    static void addDefault(Json&, const T&) {}
    template <Plain T>
    static void addDefault(Json& schema, const T& value) {
        schema["default"] = plainJson(value);
    }
    template <class T>
    static void addDefault(Json& schema, const std::optional<T>&) {
        schema["default"] = nullptr;
    }
    template <class T>
    static void addDefault(Json& schema, const std::vector<T>&) {
        schema["default"] = Json::array();
    }

    template <class T>
    void addAlternative(const char* tag) {
        properties_[tag] = schemas_.of(SchemaType<T>(), Field(Member{}));
        kinds_.push_back(Json{{"required", Json::array({tag})}});
    }

    Schemas& schemas_;
    Json properties_ = Json::object(), required_ = Json::array(), kinds_ = Json::array();
};

/// Adds rules of a part that its list of fields does not contain.
template <class T>
void addRules(Json& object) {
    if constexpr (std::is_same_v<T, SceneBody>) {
        Json& mass = object["properties"]["mass"];
        mass["anyOf"].push_back(numberSchema(Allowed::positive));
        mass["description"] =
            mass["description"].get<std::string>() + "; a number alone [kg] scales the densities of the shapes";
    }
    if constexpr (std::is_same_v<T, Scene>) object["properties"]["name"]["pattern"] = "^[a-z0-9_]+$";
    if constexpr (std::is_same_v<T, SceneJoint>) {
        Json& ends = object["dependentRequired"] = Json::object();
        for (const char* kind : tagsOfAlternatives<JointDef>) ends[kind] = Json::array({"bodyA", "bodyB"});
        ends[definitionName<GearJointDef>.tag] = Json::array({"jointA", "jointB"});
        ends[definitionName<TargetJointDef>.tag] = Json::array({"bodyA"});
    }
    if constexpr (std::is_same_v<T, SceneField>)
        object["dependentRequired"] = Json{{definitionName<Magnet>.tag, Json::array({"body"})}};
    if constexpr (std::is_same_v<T, Polygon>) {
        object["properties"]["vertices"].update(Json{{"minItems", 3}, {"maxItems", 64}});
        object["properties"]["vertices"].erase("default");
        object["required"] = Json::array({"vertices"});
    }
    if constexpr (std::is_same_v<T, Chain>) {
        object["properties"]["points"]["minItems"] = 2;
        object["properties"]["points"].erase("default");
        object["required"] = Json::array({"points"});
    }
}

template <class T>
requires(!std::is_enum_v<T>) Json Schemas::of(SchemaType<T>, const Field&) {
    constexpr PartName which = partOf<T>;
    static_assert(which.name != nullptr, "parts.h has to name this part");
    const std::string name = which.name;
    if (!definitions.contains(name)) {
        definitions[name] = nullptr;  // so that it comes before its own parts
        ObjectSchema object(*this);
        const T byDefault{};
        fields(object, byDefault);
        Json made = object.made(which.meaning);
        addRules<T>(made);
        definitions[name] = std::move(made);
    }
    return {{"$ref", "#/$defs/" + name}};
}

Json wholeSchema() {
    Schemas schemas;
    Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A scene of plumb-compare"}};
    whole.update(schemas.of(SchemaType<Scene>(), Field(Member{})));
    whole["$defs"] = std::move(schemas.definitions);
    return whole;
}

}  // namespace

std::string sceneSchema() {
    return formatJson(wholeSchema());
}

std::string sceneSchemaPage() {
    return schemaPage(wholeSchema());
}

}  // namespace plumb::compare
