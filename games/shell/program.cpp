// SPDX-License-Identifier: MIT
#include <games/shell/program.h>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>

#include <games/frame/record.h>
#include <games/shell/desktop/desktop.h>
#include <games/shell/headless/headless.h>
#include <games/shell/options.h>

namespace plumb::games {
namespace {

constexpr int done = 0, badInput = 2;

class Nobody final : public Source {
public:
    std::optional<Buttons> next(const Session&) override { return Buttons{0}; }
};

Record recordIn(const std::string& file, const GameInfo& info) {
    std::ifstream in(file);
    if (!in) throw std::invalid_argument("--replay: cannot read " + file);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    return readRecord(text, file, info);
}

void writeRecordTo(const std::string& file, const Record& record, const GameInfo& info) {
    std::ofstream out(file);
    out << textOf(record, withMenuActions(info.actions));
    if (!out.flush()) throw std::runtime_error("--record: cannot write " + file);
}

/// With a keyboard the seed is another one each time; the record contains it.
std::uint64_t seedOf(const ProgramOptions& options) {
    if (options.seed) return *options.seed;
    return options.headless || options.player != PlayedBy::Keyboard ? 1 : std::random_device{}();
}

int run(std::span<const std::string> args, const GameInfo& info) {
    const ProgramOptions options = parseOptions(args, info);
    if (!options.help.empty()) {
        std::cout << options.help;
        return done;
    }
    SessionSetup setup{seedOf(options), options.gameOptions};
    std::unique_ptr<Source> source;
    std::optional<std::uint64_t> expected;
    if (options.player == PlayedBy::Nobody) source = std::make_unique<Nobody>();
    if (options.player == PlayedBy::Computer) source = computerSource(info);
    if (options.player == PlayedBy::Record) {
        Record record = recordIn(options.replayFile, info);
        expected = record.hash;
        setup = {record.seed, record.options};
        source = recordSource(std::move(record));
    }
    const Record record = options.headless ? runHeadless(info, setup, *source, options, std::cout)
                                           : runDesktop(info, setup, source.get(), options, std::cout);
    if (!options.recordFile.empty()) writeRecordTo(options.recordFile, record, info);
    // A replay that --ticks stopped early has another hash.
    if (expected && !options.ticks && record.hash != expected)
        throw std::runtime_error(
            fmt::format("{}: the replay ended with hash {:016x}, but the record has hash {:016x}; "
                        "it is from another game or another build of it",
                        options.replayFile, *record.hash, *expected));
    return done;
}

}  // namespace

int play(const GameInfo& info, int argc, char** argv) {
    try {
        return run(std::vector<std::string>(argv + 1, argv + argc), info);
    } catch (const std::exception& error) {
        std::string line = error.what();
        std::replace(line.begin(), line.end(), '\n', ' ');
        std::cerr << "plumb-" << info.name << ": " << line << '\n';
        return badInput;
    }
}

}  // namespace plumb::games
