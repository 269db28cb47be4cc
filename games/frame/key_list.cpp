// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include <algorithm>

namespace plumb::games {
namespace {

/// Actions that share one entry of the list.
struct Entry {
    std::string about;
    std::vector<const Action*> actions;
};

std::vector<Entry> entriesOf(const std::vector<Action>& actions) {
    std::vector<Entry> entries;
    for (const Action& action : actions) {
        if (action.about.empty() || action.keys.empty()) continue;
        const auto same = std::find_if(entries.begin(), entries.end(),
                                       [&](const Entry& entry) { return entry.about == action.about; });
        if (same == entries.end())
            entries.push_back({action.about, {&action}});
        else
            same->actions.push_back(&action);
    }
    return entries;
}

/// The first keys of all its actions, then the second keys: "← → or A D".
std::string keysOf(const Entry& entry) {
    std::size_t most = 0;
    for (const Action* action : entry.actions) most = std::max(most, action->keys.size());
    std::string keys;
    for (std::size_t i = 0; i < most; ++i) {
        keys += i > 0 ? " or" : "";
        for (const Action* action : entry.actions)
            if (i < action->keys.size()) keys += (keys.empty() ? "" : " ") + std::string(nameOf(action->keys[i]));
    }
    return keys;
}

/// Letters, not bytes: an arrow is one letter of three bytes.
std::size_t lettersOf(const std::string& text) {
    const auto goesOn = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; };
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), goesOn));
}

}  // namespace

std::vector<std::string> keyLines(const std::vector<Action>& actions, std::size_t longest) {
    const std::string between = "     ·     ";
    std::vector<std::string> lines;
    for (const Entry& entry : entriesOf(actions)) {
        const std::string text = keysOf(entry) + "  " + entry.about;
        if (lines.empty() || lettersOf(lines.back() + between + text) > longest)
            lines.push_back(text);
        else
            lines.back() += between + text;
    }
    return lines;
}

}  // namespace plumb::games
