// SPDX-License-Identifier: MIT
// How does a value that has no fields of its own stand in a file?
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

#include <compare/scene/fields.h>
#include <compare/scene/json_text.h>

namespace plumb::compare {

// Compiled once: every field of every part of a scene has a call.
Json plainJson(double value);
Json plainJson(bool value);
Json plainJson(int value);
Json plainJson(std::uint64_t value);
Json plainJson(Lock value);
Json plainJson(const std::string& value);
Json plainJson(const Vec2& value);
/// An infinite one stands as a word.
Json numberOrWord(double value);
Json tagJson(std::span<const char* const> tags, std::size_t which);

template <class E>
requires std::is_enum_v<E> Json plainJson(E value) {
    return tagJson(tagsOf(value), static_cast<std::size_t>(value));
}

/// Has the type no fields of its own?
template <class T>
concept Plain = requires(const T& value) {
    plainJson(value);
};

}  // namespace plumb::compare
