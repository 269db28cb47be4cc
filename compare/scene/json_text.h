// SPDX-License-Identifier: MIT
// What is in a JSON text, and on which line?
#pragma once
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace plumb::compare {

using Json = nlohmann::ordered_json;

struct JsonText {
    Json root;
    std::map<std::string, int> lines;  ///< from the path of a value, such as bodies[2].position[0], to its line, from 1
};

/// Throws std::invalid_argument, "FILE:LINE:COLUMN: ...", for text that is not JSON, for numbers beyond the range of
/// double, and for a field that is given twice in one object.
JsonText parseJson(std::string_view text, const std::string& file);

/// The text with spaces instead of line breaks: a name in a file may have line breaks, a message must not.
std::string onOneLine(std::string text);

/// The text with an indent of two spaces; a value that fits in 120 characters is on one line.
std::string formatJson(const Json& value);

}  // namespace plumb::compare
