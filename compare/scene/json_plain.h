// SPDX-License-Identifier: MIT
// How is a value without fields of its own written in a file, and how is it read?
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

#include <compare/scene/fields.h>
#include <compare/scene/json_text.h>

namespace plumb::compare {

// Compiled once, because every field of every part of a scene calls them.
Json plainJson(double value);
Json plainJson(bool value);
Json plainJson(int value);
Json plainJson(std::uint64_t value);
Json plainJson(Lock value);
Json plainJson(const std::string& value);
Json plainJson(const Vec2& value);
/// An infinite number is written as a word.
Json numberOrWord(double value);
Json tagJson(std::span<const char* const> tags, std::size_t which);

template <class E>
requires std::is_enum_v<E> Json plainJson(E value) {
    return tagJson(tagsOf(value), static_cast<std::size_t>(value));
}

// Each throws std::invalid_argument, "bodies[2].angle: \"x\" is not a number", with the path that is given.
void readPlain(const Json& json, const std::string& path, double& value);
void readPlain(const Json& json, const std::string& path, bool& value);
void readPlain(const Json& json, const std::string& path, int& value);
void readPlain(const Json& json, const std::string& path, std::uint64_t& value);
void readPlain(const Json& json, const std::string& path, Lock& value);
void readPlain(const Json& json, const std::string& path, std::string& value);
void readPlain(const Json& json, const std::string& path, Vec2& value);
void readNumberOrWord(const Json& json, const std::string& path, double& value);
/// The place of the tag.
std::size_t readTag(const Json& json, const std::string& path, std::span<const char* const> tags);

template <class E>
requires std::is_enum_v<E>
void readPlain(const Json& json, const std::string& path, E& value) {
    value = static_cast<E>(readTag(json, path, tagsOf(value)));
}

/// Refuses a value; wanted: as "a number".
[[noreturn]] void refuseKind(const std::string& path, const Json& value, const std::string& wanted);

/// "a, b or c".
std::string oneOfText(std::span<const char* const> tags);

/// True if the type has no fields of its own.
template <class T>
concept Plain = requires(const T& value) {
    plainJson(value);
};

}  // namespace plumb::compare
