// SPDX-License-Identifier: MIT
// How do values cross between C++ and JavaScript? As rows of numbers: a struct as its members in their order, a list as
// its length and its elements, an optional value as 0, or as 1 and the value. runtime.js reads and writes the same.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/movers/grid_pass.h>
#include <plumb/movers/path_mover.h>
#include <plumb/plumb.h>
#include <plumb/steering/wander.h>
#include <web/module/members.h>
#include <web/module/path_pieces.h>

namespace plumb::web {

// A contact rule is a plain function pointer; so there are as many as JavaScript may have rules at a time, and each
// asks for its number.
inline constexpr std::size_t mostRules = 64;

/// Rules are numbered from 1; 0 is none. Throws std::invalid_argument on a number above mostRules.
ContactRule ruleOf(std::size_t number);
std::size_t numberOf(ContactRule rule);

template <class T, template <class...> class Template>
inline constexpr bool isOf = false;
template <template <class...> class Template, class... Ts>
inline constexpr bool isOf<Template<Ts...>, Template> = true;
template <class T>
inline constexpr bool isSpan = false;
template <class T>
inline constexpr bool isSpan<std::span<T>> = true;
template <class T>
inline constexpr bool isArray = false;
template <class T, std::size_t N>
inline constexpr bool isArray<std::array<T, N>> = true;

/// Objects with a state of their own that is a few bytes: in JavaScript, the bytes as numbers of 32 bits.
template <class T>
inline constexpr bool isState = std::is_same_v<T, FixedClock> || std::is_same_v<T, Random>;
template <class T>
inline constexpr std::size_t stateWords = sizeof(T) / sizeof(std::uint32_t);

/// More than a double holds: two numbers, the lower half first.
template <class T>
inline constexpr bool isBits = std::is_same_v<T, std::uint64_t>;

/// Reads values from a row that JavaScript has written. What a value refers to lives as long as the reader.
class Reader {
public:
    explicit Reader(std::span<const double> row) : at_(row.data()), end_(row.data() + row.size()) {}

    template <class T>
    T get() {
        if constexpr (isState<T>) {
            std::array<std::uint32_t, stateWords<T>> words;
            for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(next());
            return std::bit_cast<T>(words);
        } else if constexpr (std::is_same_v<T, PathMoverDef>) {
            PathMoverDef def{.path = get<MotionPath>()};
            forEachMember(def, [this]<class M>(M& member) {
                if constexpr (!std::is_same_v<M, MotionPath>) take(member);
            });
            return def;
        } else if constexpr (std::is_same_v<T, WanderState>) {
            return {get<Random>(), get<double>()};
        } else if constexpr (std::is_same_v<T, MotionPath>) {
            return pathOf(get<PathPieces>());
        } else {
            T value{};
            take(value);
            return value;
        }
    }

    double next() {
        if (at_ == end_) throw std::invalid_argument("plumb.js and plumb.wasm are not of one build");
        return *at_++;
    }

private:
    template <class T>
    void take(T& value) {
        if constexpr (isBits<T>) {
            const auto low = static_cast<std::uint32_t>(next());
            value = std::uint64_t{static_cast<std::uint32_t>(next())} << 32 | low;
        } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, Lock>) {
            value = next() != 0;
        } else if constexpr (std::is_arithmetic_v<T>) {
            value = static_cast<T>(next());
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(static_cast<int>(next()));
        } else if constexpr (std::is_same_v<T, Vec2>) {
            value.x() = next();
            value.y() = next();
        } else if constexpr (std::is_same_v<T, Rot>) {
            value = Rot::fromAngle(next());
        } else if constexpr (std::is_same_v<T, ContactRule>) {
            value = ruleOf(static_cast<std::size_t>(next()));
        } else if constexpr (std::is_same_v<T, PassRule>) {
            value = nullptr;
        } else if constexpr (std::is_same_v<T, TileMap>) {
            takeTiles(value);
        } else if constexpr (isOf<T, std::variant>) {
            takeAlternative(value, static_cast<std::size_t>(next()),
                            std::make_index_sequence<std::variant_size_v<T>>{});
        } else if constexpr (isOf<T, std::optional>) {
            if (next() != 0)
                value = get<typename T::value_type>();
            else
                value.reset();
        } else {
            takeMany(value);
        }
    }

    template <class T>
    void takeMany(T& values) {
        if constexpr (isOf<T, std::map>) {
            values.clear();
            for (auto left = static_cast<std::size_t>(next()); left > 0; --left) {
                const char sign = static_cast<char>(next());
                values[sign] = get<typename T::mapped_type>();
            }
        } else if constexpr (std::is_same_v<T, std::string>) {
            values.resize(static_cast<std::size_t>(next()));
            for (char& c : values) c = static_cast<char>(next());
        } else if constexpr (isOf<T, std::vector>) {
            values.clear();
            const auto count = static_cast<std::size_t>(next());
            values.reserve(count);
            for (std::size_t i = 0; i < count; ++i) values.push_back(get<typename T::value_type>());
        } else if constexpr (isSpan<T>) {
            auto kept = std::make_shared<std::vector<typename T::value_type>>();
            take(*kept);
            values = *kept;
            kept_.push_back(kept);
        } else if constexpr (isArray<T>) {
            if (static_cast<std::size_t>(next()) != values.size())
                throw std::invalid_argument("a list of " + std::to_string(values.size()) + " was wanted");
            for (auto& value : values) take(value);
        } else {
            forEachMember(values, [&](auto& member) { take(member); });
        }
    }

    void takeTiles(TileMap& map) {
        map = TileMap(get<TileMapDef>());
        const auto count = static_cast<int>(next());
        if (count != map.columns() * map.rows())
            throw std::invalid_argument("TileMap.tiles: " + std::to_string(count) + ", not columns times rows");
        for (int i = 0; i < count; ++i) map.set({i % map.columns(), i / map.columns()}, get<Tile>());
    }

    template <class... Ts, std::size_t... I>
    void takeAlternative(std::variant<Ts...>& value, std::size_t index, std::index_sequence<I...>) {
        ((I == index ? void(value.template emplace<I>(get<Ts>())) : void()), ...);
    }

    const double* at_;
    const double* end_;
    std::vector<std::shared_ptr<void>> kept_ = {};
};

/// Writes values into a row for JavaScript to read.
class Writer {
public:
    explicit Writer(std::vector<double>& row) : row_(row) { row_.clear(); }

    void put(double number) { row_.push_back(number); }

    template <class T>
    void add(const T& value) {
        if constexpr (isState<T>) {
            for (const std::uint32_t word : std::bit_cast<std::array<std::uint32_t, stateWords<T>>>(value)) put(word);
        } else if constexpr (isBits<T>) {
            put(static_cast<std::uint32_t>(value));
            put(static_cast<std::uint32_t>(value >> 32));
        } else if constexpr (std::is_arithmetic_v<T>) {
            put(static_cast<double>(value));
        } else if constexpr (std::is_same_v<T, Lock>) {
            put(value ? 1 : 0);
        } else if constexpr (std::is_enum_v<T>) {
            put(static_cast<int>(value));
        } else if constexpr (std::is_same_v<T, Vec2>) {
            put(value.x());
            put(value.y());
        } else if constexpr (std::is_same_v<T, Rot>) {
            put(value.angle());
        } else if constexpr (std::is_same_v<T, ContactRule>) {
            put(static_cast<double>(numberOf(value)));
        } else if constexpr (std::is_same_v<T, PassRule>) {
        } else if constexpr (std::is_same_v<T, TileMap>) {
            addTiles(value);
        } else if constexpr (isOf<T, std::variant>) {
            put(static_cast<double>(value.index()));
            std::visit([this](const auto& one) { add(one); }, value);
        } else if constexpr (isOf<T, std::optional>) {
            put(value ? 1 : 0);
            if (value) add(*value);
        } else {
            addMany(value);
        }
    }

private:
    template <class T>
    void addMany(const T& values) {
        if constexpr (isOf<T, std::map>) {
            put(static_cast<double>(values.size()));
            for (const auto& [sign, value] : values) put(static_cast<unsigned char>(sign)), add(value);
        } else if constexpr (std::is_same_v<T, std::string>) {
            put(static_cast<double>(values.size()));
            for (const char c : values) put(static_cast<unsigned char>(c));
        } else if constexpr (isOf<T, std::vector> || isSpan<T> || isArray<T>) {
            put(static_cast<double>(values.size()));
            for (const auto& value : values) add(value);
        } else {
            forEachMember(values, [&](const auto& member) { add(member); });
        }
    }

    void addTiles(const TileMap& map) {
        add(map.def());
        put(map.columns() * map.rows());
        for (int row = 0; row < map.rows(); ++row)
            for (int column = 0; column < map.columns(); ++column) add(map.at({column, row}));
    }

    std::vector<double>& row_;
};

}  // namespace plumb::web
