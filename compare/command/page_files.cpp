// SPDX-License-Identifier: MIT
#include <compare/command/page_files.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>

#include <compare/command/output_file.h>

namespace plumb::compare {

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

}  // namespace plumb::compare
