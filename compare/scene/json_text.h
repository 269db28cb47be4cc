// SPDX-License-Identifier: MIT
// What does a JSON text hold, and on which line?
#pragma once
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace plumb::compare {

using Json = nlohmann::ordered_json;

struct JsonText {
    Json root;
    std::map<std::string, int> lines;  ///< path of a value, like bodies[2].position[0], to its line, from 1
};

/// Throws std::invalid_argument, "FILE:LINE:COLUMN: ...", for text that is not JSON, for numbers beyond the range of
/// double, and for a field that stands twice in one object.
JsonText parseJson(std::string_view text, const std::string& file);

/// The text with spaces for line breaks: a name in a file may hold them, a message must not.
std::string onOneLine(std::string text);

/// The text with what fits on a line of 120 characters on one line, and two spaces an indent.
std::string formatJson(const Json& value);

}  // namespace plumb::compare
