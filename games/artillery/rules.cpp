// SPDX-License-Identifier: MIT
#include <games/artillery/rules.h>

#include <string>

#include <plumb/math/check.h>

namespace plumb::games::artillery {

const Strength& strengthOf(std::string_view name) {
    for (const Strength& strength : strengths)
        if (strength.name == name) return strength;
    refuse("strength", "\"" + std::string(name) + "\" is not weak, fair or strong");
}

}  // namespace plumb::games::artillery
