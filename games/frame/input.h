// SPDX-License-Identifier: MIT
// Which actions does the player want in this tick?
#pragma once
#include <string>
#include <string_view>

#include <games/frame/action.h>
#include <plumb/math/check.h>

namespace plumb::games {

/// The buttons of this tick and of the tick before. Every call takes an action's name, or its index in the game's own
/// list. It throws std::invalid_argument when there is no such action.
class Input {
public:
    /// The list must outlive the input.
    Input(const ActionList& actions, Buttons now, Buttons before) : actions_(&actions), now_(now), before_(before) {}

    bool held(std::string_view action) const { return held(actions_->indexOf(action)); }
    bool pressed(std::string_view action) const { return pressed(actions_->indexOf(action)); }
    bool released(std::string_view action) const { return released(actions_->indexOf(action)); }
    bool held(int action) const { return (now_ & bit(action)) != 0; }
    bool pressed(int action) const { return held(action) && (before_ & bit(action)) == 0; }    ///< held now, not before
    bool released(int action) const { return !held(action) && (before_ & bit(action)) != 0; }  ///< held before, not now

    /// 1 when positive is held, -1 when negative is, 0 when both or neither are.
    int axis(std::string_view negative, std::string_view positive) const {
        return int{held(positive)} - int{held(negative)};
    }

    Buttons now() const { return now_; }
    Buttons before() const { return before_; }

private:
    Buttons bit(int action) const;

    const ActionList* actions_;
    Buttons now_, before_;
};

inline Buttons Input::bit(int action) const {
    if (action < 0 || action >= actions_->size())
        refuse("action",
               std::to_string(action) + " is not an index; there are " + std::to_string(actions_->size()) + " actions");
    return Buttons{1} << action;
}

}  // namespace plumb::games
