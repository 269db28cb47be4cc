// SPDX-License-Identifier: MIT
// How is a part of a scene turned into JSON?
#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/scene/fields.h>
#include <compare/scene/json.h>
#include <compare/scene/json_text.h>

namespace plumb::compare {

/// Turns one struct into an object.
template <Defaults defaults>
class JsonWriter {
public:
    template <class T>
    requires(!std::is_enum_v<T>) static Json write(const T& value) {
        JsonWriter full;
        fields(full, value);
        if constexpr (defaults == Defaults::Written) return full.object_;
        const T byDefault{};
        JsonWriter plain;
        fields(plain, byDefault);
        Json kept = Json::object();
        for (const auto& [name, field] : full.object_.items()) {
            const bool isTag = name == full.tag_;  // says which alternative it is: needed even when all else is default
            if (isTag || !plain.object_.contains(name) || plain.object_[name] != field) kept[name] = field;
        }
        return kept;
    }
    static Json write(double value) { return value; }
    static Json write(bool value) { return value; }
    static Json write(const Lock& value) { return static_cast<bool>(value); }
    static Json write(std::uint64_t value) { return value; }
    static Json write(int value) { return value; }
    static Json write(const std::string& value) { return value; }
    static Json write(const Vec2& value) { return Json::array({value.x(), value.y()}); }
    static Json write(const TileMap& map) {
        return write(TilesFields{textOf(map), map.size(), map.def().wrapX, map.def().wrapY});
    }
    template <class E>
    requires std::is_enum_v<E>
    static Json write(E value) { return tagsOf(value)[static_cast<std::size_t>(value)]; }
    static Json write(const EngineSettings& settings) {
        Json object = Json::object();
        for (const auto& [engine, fields] : settings)
            for (const auto& [field, value] : fields) object[engine][field] = Json::parse(value);
        return object;
    }
    template <class T>
    static Json write(const std::optional<T>& value) {
        return value ? write(*value) : Json(nullptr);
    }
    template <class T>
    static Json write(const std::vector<T>& values) {
        Json array = Json::array();
        for (const T& value : values) array.push_back(write(value));
        return array;
    }

    template <class T>
    void operator()(const Field& field, const T& value) {
        object_[field.name] = write(value);
    }
    void orInfinite(const Field& field, double value) {
        object_[field.name] = !std::isinf(value) ? Json(value) : Json(value > 0 ? infiniteTag : minusInfiniteTag);
    }
    void shape(const Shape& shape) { oneOf(shape, tagsOfAlternatives<Shape>); }
    template <class... T>
    void oneOf(const std::variant<T...>& value, std::span<const char* const> tags) {
        tag_ = tags[value.index()];
        std::visit([&](const auto& alternative) { object_[tag_] = write(alternative); }, value);
    }

private:
    Json object_ = Json::object();
    std::string tag_;
};

}  // namespace plumb::compare
