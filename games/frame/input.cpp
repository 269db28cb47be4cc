// SPDX-License-Identifier: MIT
#include <games/frame/input.h>

#include <plumb/math/check.h>

namespace plumb::games {

Buttons Input::bit(int action) const {
    if (action < 0 || action >= actions_->size())
        refuse("action",
               std::to_string(action) + " is not an index; there are " + std::to_string(actions_->size()) + " actions");
    return Buttons{1} << action;
}

}  // namespace plumb::games
