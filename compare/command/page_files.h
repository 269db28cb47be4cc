// SPDX-License-Identifier: MIT
// Which pages are written, and do they agree with what is measured?
#pragma once
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <compare/command/arguments.h>
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

class AccuracyPages {
public:
    /// Throws std::invalid_argument if a page cannot be read or has no table of accuracy, if the arguments change how
    /// the scenes run, or if a page is to be written and not all engines run.
    AccuracyPages(const Arguments& arguments, const std::vector<Engine>& engines);

    /// Writes the tables, and compares them with the pages to be verified. False if a page differs; each difference is
    /// printed on a line.
    bool hold(std::span<const SceneResult> results, std::ostream& out) const;

private:
    PageOptions pages_;
};

}  // namespace plumb::compare
