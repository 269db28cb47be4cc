// SPDX-License-Identifier: MIT
// How does JSON become a struct with a list of fields?
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <compare/scene/json_plain.h>
#include <plumb/math/check.h>

namespace plumb::compare {

/// "the nearest known one is ...": for a field that is not among the known ones.
std::string hintForField(const std::string& name, const std::vector<std::string>& known);

/// The text of an error about a value of a text, with file and line: "FILE:LINE: bodies[2]...". message: starts with
/// the path of the value; if that path has no line, the nearest enclosing one is used.
std::string withLine(const JsonText& text, const std::string& file, const std::string& message);

/// Says which overload of read is meant, if nothing else does.
template <class T>
using JsonType = std::type_identity<T>;

/// Turns one object into a struct; a field that is not in the object keeps its default.
class JsonReader {
public:
    template <class T>
    static T read(JsonType<T>, const Json& json, const std::string& path) {
        if (!json.is_object()) refuseKind(path, json, "an object");
        T value{};
        JsonReader reader(json, path);
        fields(reader, value);
        reader.refuseUnknown();
        if (!reader.kindWanted_.empty())
            plumb::refuse(path, "does not say of what kind it is, wanted " + reader.kindWanted_);
        return value;
    }

    template <class T>
    void operator()(const Field& which, T& value) {
        take(which.name, value);
    }

    void orInfinite(const Field& which, double& value) {
        if (const Json* field = find(which.name)) readNumberOrWord(*field, member(which.name), value);
    }

    void shape(Shape& shape) {
        const Json* given = find("box");
        if (given == nullptr) return oneOf(shape, tagsOfAlternatives<Shape>);
        for (const char* other : tagsOfAlternatives<Shape>) {
            if (find(other) != nullptr)
                plumb::refuse(path_, "has both box and " + std::string(other) + ", wanted one of them");
        }
        const BoxFields box = read(JsonType<BoxFields>(), *given, member("box"));
        if (!(box.halfSize.x() > 0 && box.halfSize.y() > 0)) {
            plumb::refuse(member("box.halfSize"), toText(box.halfSize) + " is not positive");
        }
        Polygon polygon = boxPolygon(box.halfSize, box.center);
        polygon.radius = box.radius;
        shape = std::move(polygon);
    }

    template <class... T>
    void oneOf(std::variant<T...>& value, std::span<const char* const> tags) {
        std::size_t found = 0;
        for (std::size_t i = 0; i < tags.size(); ++i) {
            const bool here = find(tags[i]) != nullptr;
            if (here && found > 0) {
                plumb::refuse(path_,
                              "has both " + std::string(tags[found - 1]) + " and " + tags[i] + ", wanted one of them");
            }
            if (here) found = i + 1;
        }
        if (found == 0) {
            kindWanted_ = oneOfText(tags);  // not refused yet: a misspelled field is refused first, which says more
            return;
        }
        readAlternative(value, found - 1, tags[found - 1], std::index_sequence_for<T...>());
    }

private:
    JsonReader(const Json& object, const std::string& path) : object_(object), path_(path) {}

    std::string member(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }

    template <class T>
    void take(const char* name, T& value) {
        if (const Json* field = find(name)) value = read(JsonType<T>(), *field, member(name));
    }

    /// A name that is asked for here becomes a known name.
    const Json* find(const char* name) {
        if (std::ranges::find(known_, name) == known_.end()) known_.emplace_back(name);
        const auto field = object_.find(name);
        return field == object_.end() ? nullptr : &*field;
    }

    void refuseUnknown() const {
        for (const auto& [name, field] : object_.items()) {
            if (std::ranges::find(known_, name) != known_.end()) continue;
            plumb::refuse(member(name), "unknown field, " + hintForField(name, known_));
        }
    }

    template <class... T, std::size_t... I>
    void readAlternative(std::variant<T...>& value, std::size_t index, const char* tag, std::index_sequence<I...>) {
        const auto readAs = [&]<std::size_t i>() {
            take(tag, value.template emplace<i>());
            return true;
        };
        (void)((I == index && readAs.template operator()<I>()) || ...);
    }

    template <Plain T>
    static T read(JsonType<T>, const Json& json, const std::string& path) {
        T value{};
        readPlain(json, path, value);
        return value;
    }
    static TileMap read(JsonType<TileMap>, const Json& json, const std::string& path) {
        const TilesFields tiles = read(JsonType<TilesFields>(), json, path);
        try {
            return tileMapOf(tiles.rows, tiles.size).wrapping(tiles.wrapX, tiles.wrapY);
        } catch (const std::invalid_argument& error) {
            plumb::refuse(path, error.what());
        }
    }
    static EngineSettings read(JsonType<EngineSettings>, const Json& json, const std::string& path) {
        if (!json.is_object()) refuseKind(path, json, "an object");
        EngineSettings settings;
        for (const auto& [engine, fields] : json.items()) {
            if (!fields.is_object()) refuseKind(path + "." + engine, fields, "an object");
            for (const auto& [field, value] : fields.items()) settings[engine][field] = value.dump();
        }
        return settings;
    }
    template <class T>
    static std::optional<T> read(JsonType<std::optional<T>>, const Json& json, const std::string& path) {
        if (json.is_null()) return {};
        return read(JsonType<T>(), json, path);
    }
    template <class T>
    static std::vector<T> read(JsonType<std::vector<T>>, const Json& json, const std::string& path) {
        if (!json.is_array()) refuseKind(path, json, "a list");
        std::vector<T> values;
        for (const Json& item : json) {
            values.push_back(read(JsonType<T>(), item, path + "[" + std::to_string(values.size()) + "]"));
        }
        return values;
    }

    const Json& object_;
    const std::string& path_;
    std::vector<std::string> known_;
    std::string kindWanted_;
};

}  // namespace plumb::compare
