// SPDX-License-Identifier: MIT
// How is a function of the kit called with a row of numbers? Its type says what to read from the row and what to write.
#pragma once
#include <functional>
#include <tuple>
#include <type_traits>

#include <web/module/host.h>
#include <web/module/row.h>

namespace plumb::web {

/// A function as a type, so that what its type is can be asked.
template <auto Function>
struct Fn {};
template <auto Function>
inline constexpr Fn<Function> fn{};

template <class... Ts>
struct Types {};

/// The result and the arguments of a function; the object of a member function is its first.
template <class F>
struct Signature : Signature<decltype(&F::operator())>::Lambda {};
template <class R, class... A>
struct Signature<R (*)(A...)> {
    using Result = R;
    using Arguments = Types<A...>;
};
template <class R, class C, class... A>
struct Signature<R (C::*)(A...)> {
    using Result = R;
    using Arguments = Types<C&, A...>;
};
template <class R, class C, class... A>
struct Signature<R (C::*)(A...) const> {
    using Result = R;
    using Arguments = Types<const C&, A...>;
    using Lambda = Signature<R (*)(A...)>;
};

/// A view of a world's object, by the type of its id.
template <class T>
struct ViewOf {
    using Id = void;
};
template <>
struct ViewOf<Body> {
    using Id = BodyId;
    static Body in(World& world, const Id& id) { return world.body(id); }
};
template <>
struct ViewOf<BodyShape> {
    using Id = ShapeId;
    static BodyShape in(World& world, const Id& id) { return world.shape(id); }
};
template <>
struct ViewOf<Joint> {
    using Id = JointId;
    static Joint in(World& world, const Id& id) { return world.joint(id); }
};
template <>
struct ViewOf<Field> {
    using Id = FieldId;
    static Field in(World& world, const Id& id) { return world.field(id); }
};
template <>
struct ViewOf<BodyView> : ViewOf<Body> {};
template <>
struct ViewOf<BodyShapeView> : ViewOf<BodyShape> {};
template <>
struct ViewOf<JointView> : ViewOf<Joint> {};
template <>
struct ViewOf<FieldView> : ViewOf<Field> {};

template <class T>
inline constexpr bool isView = !std::is_void_v<typename ViewOf<T>::Id>;

/// Does a function with this first argument change an object whose state lies in JavaScript?
template <class Self>
inline constexpr bool changesState =
    std::is_lvalue_reference_v<Self> && !std::is_const_v<std::remove_reference_t<Self>> &&
    isState<std::remove_cvref_t<Self>>;

inline double addressOf(const WorldHost* host) {
    return static_cast<double>(reinterpret_cast<std::uintptr_t>(host));
}
inline WorldHost& hostIn(Reader& row) {
    auto* host = reinterpret_cast<WorldHost*>(static_cast<std::uintptr_t>(row.next()));
    if (host == nullptr) throw std::invalid_argument("this world has been freed");
    return *host;
}

/// One argument, from the row. By value where it may be, so that the order of reading is that of a braced list.
template <class Argument>
decltype(auto) argumentIn(Reader& row) {
    using T = std::remove_cvref_t<Argument>;
    if constexpr (std::is_same_v<T, World>) {
        return std::ref(hostIn(row).world);
    } else if constexpr (std::is_same_v<T, WorldHost>) {
        return std::ref(hostIn(row));
    } else if constexpr (isView<T>) {
        WorldHost& host = hostIn(row);
        return ViewOf<T>::in(host.world, row.get<typename ViewOf<T>::Id>());
    } else if constexpr (isHeld<T>) {
        WorldHost& host = hostIn(row);
        return T(host, row.get<std::uint32_t>());
    } else if constexpr (std::is_same_v<T, std::string_view>) {
        return row.get<std::string>();
    } else {
        return row.get<T>();
    }
}

template <class T>
void addResult(Writer& out, const T& result) {
    if constexpr (isView<T>)
        out.add(result.id());
    else
        out.add(result);
}

/// Calls the function when it is made: the arguments of a constructor in braces are worked out from left to right, as
/// they stand in the row.
template <auto Function, class Self>
struct Invocation {
    template <class... A>
    Invocation(Writer& out, A&&... arguments) {
        if constexpr (std::is_void_v<decltype(std::invoke(Function, arguments...))>)
            std::invoke(Function, arguments...);
        else
            addResult(out, std::invoke(Function, arguments...));
        if constexpr (changesState<Self>) writeBack(out, arguments...);
    }

    /// The state of an object that lies in JavaScript.
    static void writeBack(Writer& out, const auto& self, const auto&...) { out.add(self); }
};

template <auto Function, class... A>
void callWith(Types<A...>, Reader& in, Writer& out) {
    using Self = std::tuple_element_t<0, std::tuple<A..., void>>;
    Invocation<Function, Self>{out, argumentIn<A>(in)...};
}

/// Reads the arguments, calls, and writes the result.
template <auto Function>
void call(Reader& in, Writer& out) {
    callWith<Function>(typename Signature<std::remove_const_t<decltype(Function)>>::Arguments{}, in, out);
}

using Call = void (*)(Reader&, Writer&);

}  // namespace plumb::web
