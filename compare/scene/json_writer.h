// SPDX-License-Identifier: MIT
// How does a struct with a list of fields become JSON?
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <compare/scene/json.h>
#include <compare/scene/json_plain.h>

namespace plumb::compare {

/// Turns one struct into an object.
class JsonWriter {
public:
    explicit JsonWriter(Defaults defaults) : defaults_(defaults) {}

    template <Plain T>
    Json write(const T& value) const {
        return plainJson(value);
    }
    template <class T>
    Json write(const T& value) const {
        JsonWriter full(defaults_);
        fields(full, value);
        if (defaults_ == Defaults::Written) return std::move(full.object_);
        const T byDefault{};
        JsonWriter plain(defaults_);
        fields(plain, byDefault);
        return full.without(plain.object_);
    }
    Json write(const TileMap& map) const {
        return write(TilesFields{textOf(map), map.size(), map.def().wrapX, map.def().wrapY});
    }
    Json write(const EngineSettings& settings) const {
        Json object = Json::object();
        for (const auto& [engine, fields] : settings)
            for (const auto& [field, value] : fields) object[engine][field] = Json::parse(value);
        return object;
    }
    template <class T>
    Json write(const std::optional<T>& value) const {
        return value ? write(*value) : Json(nullptr);
    }
    template <class T>
    Json write(const std::vector<T>& values) const {
        Json array = Json::array();
        for (const T& value : values) array.push_back(write(value));
        return array;
    }

    template <class T>
    void operator()(const Field& field, const T& value) {
        put(field.name, write(value));
    }
    void orInfinite(const Field& field, double value) { put(field.name, numberOrWord(value)); }
    void shape(const Shape& shape) { oneOf(shape, tagsOfAlternatives<Shape>); }
    template <class... T>
    void oneOf(const std::variant<T...>& value, std::span<const char* const> tags) {
        tag_ = tags[value.index()];
        std::visit([&](const auto& alternative) { put(tag_, write(alternative)); }, value);
    }

private:
    void put(const std::string& name, Json value) { object_[name] = std::move(value); }

    /// The fields that differ from the default. The tag is always kept: it says which alternative this is.
    Json without(const Json& byDefault) const {
        Json kept = Json::object();
        for (const auto& [name, field] : object_.items())
            if (name == tag_ || !byDefault.contains(name) || byDefault[name] != field) kept[name] = field;
        return kept;
    }

    Defaults defaults_;
    Json object_ = Json::object();
    std::string tag_;
};

}  // namespace plumb::compare
