// SPDX-License-Identifier: MIT
#include <games/shell/headless/headless.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include <games/shell/headless/screenshots.h>

namespace plumb::games {
namespace {

std::string nameOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::Won: return "won";
        case Outcome::Lost: return "lost";
        case Outcome::Running: break;
    }
    return "running";
}

std::string summary(const Session& session, std::uint64_t seed) {
    nlohmann::ordered_json line;
    const Progress progress = session.progress();
    line["game"] = session.info().name;
    line["seed"] = seed;
    line["ticks"] = session.ticks();
    line["result"] = nameOf(progress.outcome);
    line["score"] = progress.score;
    line["hash"] = fmt::format("{:016x}", session.hash());
    return line.dump();
}

}  // namespace

Record runHeadless(const GameInfo& info, const SessionSetup& setup, Source& source, const ProgramOptions& options,
                   std::ostream& out) {
    Session session(info, setup);
    session.showDebug(options.debug);
    Record record{info.name, setup.seed, setup.options};
    const bool toTheEnd = options.player == PlayedBy::Record;
    Screenshots screenshots(options.screenshots, options.size);
    screenshots.take(session);
    while (!options.ticks || session.ticks() < *options.ticks) {
        if (!toTheEnd && session.screen() == Screen::Over) break;
        const std::optional<Buttons> buttons = source.next(session);
        if (!buttons) break;
        session.update(*buttons);
        session.takeCues();
        record.add(*buttons);
        screenshots.take(session);
    }
    screenshots.requireDone(session.ticks());
    record.hash = session.hash();
    out << summary(session, setup.seed) << '\n';
    return record;
}

}  // namespace plumb::games
