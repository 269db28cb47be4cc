// SPDX-License-Identifier: MIT
// How do measured times stand in compare/README.md?
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include <compare/bench/result.h>

namespace plumb::compare {

/// The table and what belongs to it, in Markdown.
std::string benchMarkdown(std::span<const SceneBench> results);

/// The text with what stands between the lines <!-- bench begin --> and <!-- bench end --> replaced.
/// Throws std::invalid_argument when they are not there, once each and in this order.
std::string withBench(const std::string& text, const std::string& markdown);

/// The text of a file that has the two lines. Throws std::invalid_argument when it cannot be read, or as withBench.
std::string readReadme(const std::filesystem::path& path);

}  // namespace plumb::compare
