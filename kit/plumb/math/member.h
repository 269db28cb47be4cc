// SPDX-License-Identifier: MIT
// What is said of a member of a definition: its name, its unit, what it may hold, and what it means?
//
// Each definition, as BodyDef or RevoluteJointDef, is described once, in a header beside it whose name begins with
// describe. There, describe(def, visit) calls visit(Member, def.member) for each member, in their order. Checks, files
// and bindings to other languages are visitors. No header of a definition includes a description: it costs only the
// sources that use it.
#pragma once
#include <array>
#include <concepts>
#include <limits>
#include <span>
#include <type_traits>
#include <variant>

namespace plumb {

/// Of which bodies is a point an anchor? They are counted as the definition names them.
enum class AnchorOf { None, First, Second, Both };

/// What a number, or each coordinate of a vector or of a list of vectors, may be. What is no number is checked by its
/// own description, or by whoever knows what it names.
struct Allowed {
    enum class Sign { Any, NotNegative, Positive };

    bool anything = false;  ///< no value of the member's type is refused
    Sign sign = Sign::Any;
    bool infinite = false;       ///< may be infinite
    bool minusInfinite = false;  ///< may be -infinite
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();  ///< no farther than this from 0
    const char* beyond = nullptr;                           ///< why not
    const char* instead = nullptr;    ///< of a range: what to do for more than its upper end; nullptr: nothing is known
    const char* zero = nullptr;       ///< why it may not be 0; nullptr: it may
    std::span<const int> oneOf = {};  ///< one of these; none: any
    bool once = false;                ///< is given when a thing is made, and never changes
    AnchorOf anchor = AnchorOf::None;  ///< a point that must be near these bodies

    static const Allowed any, finite, notNegative, positive;
    static constexpr Allowed within(double low, double high);
    static constexpr Allowed among(std::span<const int> choices);

    constexpr Allowed orInfinite() const;
    constexpr Allowed orMinusInfinite() const;
    constexpr Allowed upTo(double furthest, const char* why) const;
    constexpr Allowed insteadOfMore(const char* way) const;
    constexpr Allowed butNotZero(const char* why) const;
    constexpr Allowed onlyOnce() const;
    constexpr Allowed anchorOf(AnchorOf bodies) const;

    constexpr bool isRange() const { return low > -std::numeric_limits<double>::infinity(); }
};

inline constexpr Allowed Allowed::any{.anything = true};
inline constexpr Allowed Allowed::finite{};
inline constexpr Allowed Allowed::notNegative{.sign = Sign::NotNegative};
inline constexpr Allowed Allowed::positive{.sign = Sign::Positive};

constexpr Allowed Allowed::within(double low, double high) {
    return {.low = low, .high = high};
}
constexpr Allowed Allowed::among(std::span<const int> choices) {
    return {.oneOf = choices};
}
constexpr Allowed Allowed::orInfinite() const {
    Allowed changed = *this;
    changed.infinite = true;
    return changed;
}
constexpr Allowed Allowed::orMinusInfinite() const {
    Allowed changed = *this;
    changed.minusInfinite = true;
    return changed;
}
constexpr Allowed Allowed::upTo(double furthest, const char* why) const {
    Allowed changed = *this;
    changed.most = furthest;
    changed.beyond = why;
    return changed;
}
constexpr Allowed Allowed::insteadOfMore(const char* way) const {
    Allowed changed = *this;
    changed.instead = way;
    return changed;
}
constexpr Allowed Allowed::butNotZero(const char* why) const {
    Allowed changed = *this;
    changed.zero = why;
    return changed;
}
constexpr Allowed Allowed::onlyOnce() const {
    Allowed changed = *this;
    changed.once = true;
    return changed;
}
constexpr Allowed Allowed::anchorOf(AnchorOf bodies) const {
    Allowed changed = onlyOnce();
    changed.anchor = bodies;
    return changed;
}

struct Member {
    const char* name = "";     ///< as in the struct
    const char* unit = "";     ///< "m/s"; "-" for a number without one, "" for what is no number
    Allowed allowed = {};      ///< what it may hold
    const char* meaning = "";  ///< a phrase
};

/// Names of a definition: of its type, and, of one of several alternatives, the word that tells them apart in a file.
struct DefinitionName {
    const char* type = nullptr;  ///< "RevoluteJointDef"
    const char* tag = "";        ///< "revolute"
};

/// Stands before the description of each definition.
template <class Def>
inline constexpr DefinitionName definitionName{};

/// Can T be described, if its header is included?
template <class T>
concept Described = definitionName<std::remove_const_t<T>>
.type != nullptr;

/// Is T this definition, or a const one? So that one description serves who reads and who writes.
template <class T, class Def>
concept OrConst = std::same_as<std::remove_const_t<T>, Def>;

template <class Variant>
struct AlternativeTags;
template <Described... Defs>
struct AlternativeTags<std::variant<Defs...>> {
    static constexpr std::array<const char*, sizeof...(Defs)> tags{definitionName<Defs>.tag...};
};

/// The tags of a variant's alternatives, in their order.
template <class Variant>
inline constexpr const auto& tagsOfAlternatives = AlternativeTags<Variant>::tags;

}  // namespace plumb
