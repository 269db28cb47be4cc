// SPDX-License-Identifier: MIT
// Which parts of a page are written by commands?
//
// A block stands between two lines, which readers of the page do not see:
//   <!-- bench: speed, checksum 0123456789abcdef -->
//   ...
//   <!-- end -->
// The command that writes a block writes the checksum of what it wrote: whoever changes a number by hand is found out.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plumb::compare {

struct Block {
    std::string command;   ///< "bench" or "check": which writes it
    std::string name;      ///< unique on its page for this command
    std::string checksum;  ///< as it stands there; empty before it was first written
    std::string body;      ///< the lines between

    /// The body is what the command wrote.
    bool isIntact() const;
};

/// In their order. Throws std::invalid_argument for a block that does not end, or whose command and name come twice.
std::vector<Block> blocksOf(const std::string& page);

/// The page with the bodies of those of the given blocks that it has, and their checksums. Else it stays as it is.
std::string withBlocks(const std::string& page, const std::vector<Block>& blocks);

/// The text of a file that has a block of the command. Throws std::invalid_argument when it cannot be read or has none,
/// and as blocksOf does.
std::string readPage(const std::filesystem::path& path, const std::string& command);

}  // namespace plumb::compare
