// SPDX-License-Identifier: MIT
#include <compare/page/blocks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <stdexcept>

namespace plumb::compare {
namespace {

constexpr std::string_view endLine = "<!-- end -->";

/// 64 bits, FNV-1a (Fowler, Noll and Vo). It finds small changes by hand, but is no protection against attacks.
std::string checksumOf(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

struct Found {
    Block block;
    std::size_t begin = 0, end = 0;  // positions of its first and its last line in the page
};

std::string firstLineOf(const Block& block) {
    return fmt::format("<!-- {}: {}, checksum {} -->\n", block.command, block.name, checksumOf(block.body));
}

std::vector<Found> find(const std::string& page) {
    static const std::regex first("<!-- (bench|check): ([a-z_]+)(?:, checksum ([0-9a-f]{16}))? -->\n");
    std::vector<Found> found;
    for (auto each = std::sregex_iterator(page.begin(), page.end(), first); each != std::sregex_iterator(); ++each) {
        const auto begin = static_cast<std::size_t>(each->position());
        const std::size_t body = begin + static_cast<std::size_t>(each->length());
        const std::size_t end = page.find(endLine, body);
        if (end == std::string::npos || page.substr(body, end - body).find("<!-- ") != std::string::npos)
            throw std::invalid_argument(fmt::format("the block {} has no line {}", each->str(2), endLine));
        const Block block{each->str(1), each->str(2), each->str(3), page.substr(body, end - body)};
        for (const Found& other : found)
            if (other.block.command == block.command && other.block.name == block.name)
                throw std::invalid_argument(fmt::format("the block {} comes twice", block.name));
        found.push_back({block, begin, end});
    }
    return found;
}

}  // namespace

bool Block::isIntact() const {
    return checksum == checksumOf(body);
}

std::vector<Block> blocksOf(const std::string& page) {
    std::vector<Block> blocks;
    for (Found& found : find(page)) blocks.push_back(std::move(found.block));
    return blocks;
}

std::string withBlocks(const std::string& page, const std::vector<Block>& blocks) {
    std::string text;
    std::size_t done = 0;
    for (const Found& old : find(page)) {
        const auto now = std::ranges::find_if(blocks, [&](const Block& block) {
            return block.command == old.block.command && block.name == old.block.name;
        });
        if (now == blocks.end()) continue;
        text += page.substr(done, old.begin - done) + firstLineOf(*now) + now->body;
        done = old.end;
    }
    return text + page.substr(done);
}

std::string readPage(const std::filesystem::path& path, const std::string& command) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw std::invalid_argument(path.string() + ": cannot be read");
    try {
        for (const Block& block : blocksOf(text))
            if (block.command == command) return text;
        throw std::invalid_argument(fmt::format("it has no block <!-- {}: NAME --> ... {}", command, endLine));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path.string() + ": " + error.what());
    }
}

}  // namespace plumb::compare
