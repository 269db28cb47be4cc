// SPDX-License-Identifier: MIT
// How does a value own an object whose class is chosen while the program runs?
#pragma once
#include <memory>
#include <utility>

namespace plumb {

/// Owns an object of Base or of a class derived from it, at first one of Base. It is copied with its owner, by
/// Base::copy().
template <class Base>
class Owned {
public:
    Owned() : object_(std::make_unique<Base>()) {}
    Owned(const Owned& other) : object_(other.object_->copy()) {}
    Owned(Owned&&) = default;
    Owned& operator=(const Owned& other) { return *this = Owned(other); }
    Owned& operator=(Owned&&) = default;
    Owned& operator=(std::unique_ptr<Base> object) {
        object_ = std::move(object);
        return *this;
    }

    Base& operator*() const { return *object_; }
    Base* operator->() const { return object_.get(); }

private:
    std::unique_ptr<Base> object_;
};

}  // namespace plumb
