// SPDX-License-Identifier: MIT
// What does JavaScript hold? A world, and in it the movers that were made for it; nothing else has memory here.
#pragma once
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <plumb/movers/grid_mover.h>
#include <plumb/movers/path_mover.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/plumb.h>

namespace plumb::web {

/// Objects that are known by a number, which is used again when they are gone.
template <class T>
class Slots {
public:
    std::size_t put(T&& object) {
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (!all_[i]) return all_[i].emplace(std::move(object)), i;
        all_.emplace_back(std::move(object));
        return all_.size() - 1;
    }
    T& at(std::size_t number) {
        if (number >= all_.size() || !all_[number]) throw std::invalid_argument("this mover has been freed");
        return *all_[number];
    }
    void release(std::size_t number) {
        if (number < all_.size()) all_[number].reset();
    }

private:
    std::vector<std::optional<T>> all_ = {};
};

struct WorldHost {
    World world;
    std::tuple<Slots<GridMover>, Slots<PlatformMover>, Slots<PathMover>> movers = {};

    template <class Mover>
    Slots<Mover>& of() {
        return std::get<Slots<Mover>>(movers);
    }
};

/// A mover of a world.
template <class T>
class Held {
public:
    Held(WorldHost& host, std::size_t number) : host_(&host), number_(number) {}
    T* operator->() const { return &host_->of<T>().at(number_); }
    World& world() const { return host_->world; }
    void free() const { host_->of<T>().release(number_); }

private:
    WorldHost* host_;
    std::size_t number_;
};

template <class T>
inline constexpr bool isHeld = false;
template <class T>
inline constexpr bool isHeld<Held<T>> = true;

// What do all bodies, contacts or events of a world look like as one list of numbers?

enum class Rows {
    Poses,       ///< x, y, angle at 3 times the index of a body; NaN where none is
    Velocities,  ///< vx, vy, angular velocity, likewise
    Contacts,    ///< a row a point, see contactColumns in runtime.js
    Events,      ///< a row an event, see eventColumns in runtime.js
};

void allRows(const World& world, Rows rows, std::vector<double>& out);

}  // namespace plumb::web
