// SPDX-License-Identifier: MIT
#include <games/frame/menu.h>

#include <algorithm>

#include <plumb/math/check.h>

namespace plumb::games {
namespace {

const Option& optionNamed(const GameInfo& info, const std::string& name) {
    for (const Option& option : info.options)
        if (option.name == name) return option;
    refuse("option", info.name + " has no option \"" + name + "\"");
}

void requireChoice(const Option& option, const std::string& value) {
    const auto& choices = option.choices;
    if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    std::string wanted;
    for (const std::string& choice : choices) wanted += (wanted.empty() ? "" : ", ") + choice;
    refuse("--" + option.name, "\"" + value + "\" is not one of " + wanted);
}

}  // namespace

std::map<std::string, std::string> optionsOf(const GameInfo& info, const std::map<std::string, std::string>& given) {
    std::map<std::string, std::string> options;
    for (const Option& option : info.options) options[option.name] = option.value;
    for (const auto& [name, value] : given) {
        requireChoice(optionNamed(info, name), value);
        options[name] = value;
    }
    return options;
}

std::vector<Option> optionsToChoose(const GameInfo& info) {
    std::vector<Option> shown;
    for (const Option& option : info.options)
        if (!option.choices.empty() && option.inTitle) shown.push_back(option);
    return shown;
}

const std::string& choiceBehind(const Option& option, const std::string& now, int steps) {
    const auto& choices = option.choices;
    const auto at = std::find(choices.begin(), choices.end(), now) - choices.begin();
    const auto count = static_cast<std::ptrdiff_t>(choices.size());
    return choices[static_cast<std::size_t>((at + steps + count) % count)];
}

const std::string& GameSetup::option(const std::string& name) const {
    const auto found = options.find(name);
    if (found == options.end()) refuse("option", "this game has no option \"" + name + "\"");
    return found->second;
}

}  // namespace plumb::games
