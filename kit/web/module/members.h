// SPDX-License-Identifier: MIT
// Of which members does a struct consist, and what are its members and enumerators called?
// Clang tells it: a pack of structured bindings has one binding for each member, and the text of an address or of an
// enumerator as a template's argument has its name. So a struct of the kit needs no list of its members here.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace plumb::web {

/// Calls visit(member) for each member, in their order.
template <class T, class Visit>
void forEachMember(T& value, Visit&& visit) {
    auto& [... members] = value;
    (visit(members), ...);
}

/// An object that exists only to have addresses.
template <class T>
struct Specimen {
    union {
        T value;
    };
    constexpr Specimen() {}
    constexpr ~Specimen() {}
};
template <class T>
inline const Specimen<T> specimen;

template <class T>
consteval std::size_t memberCount() {
    const auto& [... members] = specimen<T>.value;
    return sizeof...(members);
}

template <class T, std::size_t I>
consteval auto addressOfMember() {
    const auto& [... members] = specimen<T>.value;
    return &members...[I];
}

/// What follows the last separator in the text of a template's argument.
constexpr std::string_view lastWord(std::string_view text) {
    text.remove_suffix(1);  // "]"
    return text.substr(text.find_last_of(".:") + 1);
}

template <auto Address>
constexpr std::string_view nameOfMember() {
    return lastWord(__PRETTY_FUNCTION__);
}

template <class T>
std::array<std::string_view, memberCount<T>()> memberNames() {
    return []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<std::string_view, sizeof...(I)>{nameOfMember<addressOfMember<T, I>()>()...};
    }
    (std::make_index_sequence<memberCount<T>()>{});
}

/// "SlopeUp", or a text that ends with a number if the enumeration has no such value.
template <auto Value>
constexpr std::string_view nameOfEnumerator() {
    return lastWord(__PRETTY_FUNCTION__);
}

/// The number of enumerators, which count from 0.
template <class E, int Value = 0>
consteval int enumeratorCount() {
    constexpr char last = nameOfEnumerator<static_cast<E>(Value)>().back();
    if constexpr (last >= '0' && last <= '9')
        return Value;
    else
        return enumeratorCount<E, Value + 1>();
}

}  // namespace plumb::web
