// SPDX-License-Identifier: MIT
#include <games/shell/program.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
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
    return readRecord(in, file, info);
}

int run(std::span<const std::string> args, const GameInfo& info) {
    const ProgramOptions options = parseOptions(args, info);
    if (!options.help.empty()) {
        std::cout << options.help;
        return done;
    }
    SessionSetup setup{options.seed.value_or(1), options.gameOptions};
    std::unique_ptr<Source> source;
    if (options.player == PlayedBy::Nobody) source = std::make_unique<Nobody>();
    if (options.player == PlayedBy::Computer) source = computerSource(info);
    if (options.player == PlayedBy::Record) {
        Record record = recordIn(options.replayFile, info);
        setup = {record.seed, record.options};
        source = recordSource(std::move(record));
    }
    const Record record = options.headless ? runHeadless(info, setup, *source, options, std::cout)
                                           : runDesktop(info, setup, source.get(), options, std::cout);
    if (!options.recordFile.empty()) {
        std::ofstream out(options.recordFile);
        writeRecord(out, record, withMenuActions(info.actions));
    }
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
