// SPDX-License-Identifier: MIT
// How is a callback of any type passed to a function, without a template for each type?
#pragma once
#include <type_traits>
#include <utility>

namespace plumb {

template <class Signature>
class FunctionRef;

/// A non-owning reference to a callable: for parameters only, as it must not outlive the call. A callable that takes
/// only the first argument is accepted, too. A call costs an indirect call, so it is not for innermost loops.
template <class Result, class First, class... Rest>
class FunctionRef<Result(First, Rest...)> {
public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             (std::is_invocable_r_v<Result, Function&, First, Rest...> ||
              std::is_invocable_r_v<Result, Function&, First>)) FunctionRef(Function&& function)
        : function_(const_cast<void*>(static_cast<const void*>(&function))),
          call_([](void* target, First first, Rest... rest) -> Result {
              auto& called = *static_cast<std::remove_reference_t<Function>*>(target);
              if constexpr (std::is_invocable_r_v<Result, Function&, First, Rest...>)
                  return called(std::forward<First>(first), std::forward<Rest>(rest)...);
              else
                  return called(std::forward<First>(first));
          }) {}

    Result operator()(First first, Rest... rest) const {
        return call_(function_, std::forward<First>(first), std::forward<Rest>(rest)...);
    }

private:
    void* function_;
    Result (*call_)(void*, First, Rest...);
};

}  // namespace plumb
