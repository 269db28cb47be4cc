// SPDX-License-Identifier: MIT
#include <games/shell/options.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace plumb::games {
namespace {

/// The words of the command line, before they are checked.
struct Words {
    std::string seed, player;
    std::vector<std::string> files;
    std::vector<std::int64_t> at;
    std::string size;
    std::map<std::string, std::string> game;
};

void addGameOptions(CLI::App& app, const GameInfo& info, Words& words) {
    for (const Option& option : info.options) {
        std::string about = option.about;
        if (!option.choices.empty()) about += fmt::format(" ({})", fmt::join(option.choices, ", "));
        app.add_option("--" + option.name, words.game[option.name], about + " [" + option.value + "]")
            ->group(info.title);
    }
}

void addOptions(CLI::App& app, const GameInfo& info, ProgramOptions& options, Words& words) {
    const CLI::Validator ticks = CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000});
    app.add_option("--seed", words.seed, "Seed of the random numbers: the same seed gives the same game");
    app.add_option("--player", words.player, "Who plays: keyboard, computer or nobody")
        ->check(CLI::IsMember({"keyboard", "computer", "nobody"}));
    app.add_option("--record", options.recordFile, "Write the pressed buttons to this file");
    app.add_option("--replay", options.replayFile, "Replay the record in this file");
    app.add_flag("--headless", options.headless, "Run without a window; print one line of JSON at the end");
    app.add_option("--ticks", options.ticks, "Stop after this number of ticks, 60 a second")->check(ticks);
    app.add_option("--screenshot", words.files,
                   "Write a PNG picture to this file; may be given several times, each with its --at");
    app.add_option("--at", words.at, "Tick after which the picture is taken")->check(ticks);
    app.add_option("--size", words.size, "Size of the pictures, or of the window, such as 1280x720");
    app.add_flag("--debug", options.debug, "Show outlines, contacts, joints and velocities, as F1 does");
    app.add_flag("--times", options.times,
                 "With a window: print one line of JSON at the end with the times of ticks and frames");
    addGameOptions(app, info, words);
}

// Not read by the library: it would read -1 as 2^64 - 1.
std::uint64_t seedIn(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument(fmt::format("--seed: \"{}\" is not a whole number from 0 to 2^64 - 1", text));
    return seed;
}

PixelSize sizeIn(const std::string& text) {
    PixelSize size;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) != 2 || size.width < 64 ||
        size.height < 36 || size.width > 8192 || size.height > 8192)
        throw std::invalid_argument(
            fmt::format("--size: \"{}\" is not a width and a height from 64x36 to 8192x8192", text));
    return size;
}

PlayedBy playerIn(const Words& words, const ProgramOptions& options, const GameInfo& info) {
    if (!options.replayFile.empty()) {
        if (!words.player.empty()) throw std::invalid_argument("--player: not allowed with --replay; the record plays");
        if (options.seed) throw std::invalid_argument("--seed: not allowed with --replay; the record has its own seed");
        for (const auto& [name, value] : words.game)
            if (!value.empty())
                throw std::invalid_argument("--" + name + ": not allowed with --replay; the record has its own value");
        return PlayedBy::Record;
    }
    if (words.player == "computer" || (words.player.empty() && options.headless && info.computer)) {
        if (!info.computer) throw std::invalid_argument("--player: " + info.name + " has no computer player");
        return PlayedBy::Computer;
    }
    if (options.headless && words.player == "keyboard")
        throw std::invalid_argument("--player: there is no keyboard with --headless");
    return words.player == "nobody" || options.headless ? PlayedBy::Nobody : PlayedBy::Keyboard;
}

void takeScreenshots(const Words& words, ProgramOptions& options) {
    if (words.files.size() != words.at.size())
        throw std::invalid_argument(
            fmt::format("--screenshot: each needs its --at; given are {} of --screenshot and {} of --at",
                        words.files.size(), words.at.size()));
    for (std::size_t i = 0; i < words.files.size(); ++i) options.screenshots.push_back({words.files[i], words.at[i]});
    const auto earlier = [](const Screenshot& a, const Screenshot& b) { return a.at < b.at; };
    std::stable_sort(options.screenshots.begin(), options.screenshots.end(), earlier);
}

}  // namespace

ProgramOptions parseOptions(std::span<const std::string> args, const GameInfo& info) {
    ProgramOptions options;
    Words words;
    CLI::App app(info.title + ": " + info.about, "plumb-" + info.name);
    addOptions(app, info, options, words);
    try {
        app.parse(std::vector<std::string>(args.rbegin(), args.rend()));
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    }
    if (!words.seed.empty()) options.seed = seedIn(words.seed);
    if (!words.size.empty()) options.size = sizeIn(words.size);
    options.player = playerIn(words, options, info);
    takeScreenshots(words, options);
    for (const auto& [name, value] : words.game)
        if (!value.empty()) options.gameOptions[name] = value;
    if (options.headless && options.player == PlayedBy::Nobody && !options.ticks)
        throw std::invalid_argument("--ticks: needed if nobody plays; otherwise the game would never end");
    return options;
}

}  // namespace plumb::games
