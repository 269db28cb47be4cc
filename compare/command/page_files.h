// SPDX-License-Identifier: MIT
// Which pages are written?
#pragma once
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include <compare/page/blocks.h>

namespace plumb::compare {

class PageFiles {
public:
    /// Throws std::invalid_argument as readPage does.
    PageFiles(std::vector<std::filesystem::path> files, std::string command);

    bool empty() const { return files_.empty(); }
    /// Writes into each page the blocks that it has. Reports blocks of the command that were not measured, which stay
    /// as they are. Throws std::runtime_error if a file cannot be written.
    void write(const std::vector<Block>& blocks, std::ostream& out) const;

private:
    std::vector<std::filesystem::path> files_;
    std::string command_;
};

}  // namespace plumb::compare
