// SPDX-License-Identifier: MIT
#include <compare/command/page_files.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include <compare/command/output_file.h>
#include <compare/page/accuracy_tables.h>

namespace plumb::compare {
namespace {

constexpr const char* command = "check";  // the command that writes these tables

void requireAll(const std::vector<Engine>& engines) {
    for (const std::string& name : accuracyEngines())
        if (std::ranges::find(engines, name, &Engine::name) == engines.end())
            throw std::invalid_argument(
                fmt::format("--readme: the tables have a column of {}, which is not in this build", name));
}

}  // namespace

PageFiles::PageFiles(std::vector<std::filesystem::path> files, std::string command)
    : files_(std::move(files)), command_(std::move(command)) {
    for (const std::filesystem::path& file : files_) (void)readPage(file, command_);
}

void PageFiles::write(const std::vector<Block>& blocks, std::ostream& out) const {
    for (const std::filesystem::path& file : files_) {
        const std::string page = readPage(file, command_);
        OutputFile("--readme", file).write(withBlocks(page, blocks));
        for (const Block& old : blocksOf(page))
            if (old.command == command_ && std::ranges::find(blocks, old.name, &Block::name) == blocks.end())
                fmt::print(out, "{}: the block {} stays as it is: not all of its scenes were run\n", file.string(),
                           old.name);
    }
}

AccuracyPages::AccuracyPages(const Arguments& arguments, const std::vector<Engine>& engines) : pages_(arguments.pages) {
    if (pages_.written.empty() && pages_.verified.empty()) return;
    const RunOptions& options = arguments.options;
    if (options.steps || options.dt || !options.engines.empty())
        throw std::invalid_argument(
            "--readme, --verify: the pages tell of all engines and the scenes as they are, wanted "
            "no --steps, --dt or --engines");
    if (!pages_.written.empty()) requireAll(engines);
    for (const auto& list : {pages_.written, pages_.verified})
        for (const std::filesystem::path& page : list) (void)readPage(page, command);
}

bool AccuracyPages::hold(std::span<const SceneResult> results, std::ostream& out) const {
    if (pages_.written.empty() && pages_.verified.empty()) return true;
    const std::vector<AccuracyTable> tables = accuracyTables(results);
    PageFiles(pages_.written, command).write(blocksOf(tables), out);
    bool all = true;
    for (const std::filesystem::path& page : pages_.verified) {
        const std::vector<std::string> faults = pageFaults(readPage(page, command), tables);
        for (const std::string& fault : faults) fmt::print(out, "{}: {}\n", page.string(), fault);
        if (faults.empty()) fmt::print(out, "{} says what was measured.\n", page.string());
        all = all && faults.empty();
    }
    return all;
}

}  // namespace plumb::compare
