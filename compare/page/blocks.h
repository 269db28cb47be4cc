// SPDX-License-Identifier: MIT
// Which parts of a page are written by commands?
//
// A block is between two lines that readers of the page do not see:
//   <!-- bench: speed, checksum 0123456789abcdef -->
//   ...
//   <!-- end -->
// The command that writes a block also writes the block's checksum: so a number changed by hand is found.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plumb::compare {

struct Block {
    std::string command;   ///< "bench" or "check": the command that writes it
    std::string name;      ///< unique on its page for this command
    std::string checksum;  ///< as written in the page; empty before the block is first written
    std::string body;      ///< the lines between the two

    /// True if the body is as the command wrote it.
    bool isIntact() const;
};

/// The blocks in the order of the page. Throws std::invalid_argument if a block does not end, or if its command and
/// name come twice.
std::vector<Block> blocksOf(const std::string& page);

/// The page with new bodies and checksums for those of the given blocks that it has. The rest stays as it is.
std::string withBlocks(const std::string& page, const std::vector<Block>& blocks);

/// The text of a file that has a block of the command. Throws std::invalid_argument if the file cannot be read or has
/// no such block, and in the cases in which blocksOf does.
std::string readPage(const std::filesystem::path& path, const std::string& command);

}  // namespace plumb::compare
