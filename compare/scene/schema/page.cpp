// SPDX-License-Identifier: MIT
#include <compare/scene/schema/schema.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace plumb::compare {
namespace {

/// The text as a cell of a table.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
    return text;
}

std::string linkTo(const Json& reference) {
    const auto text = reference.get<std::string>();
    const std::string name = text.substr(text.rfind('/') + 1);
    std::string anchor = name;
    std::ranges::transform(anchor, anchor.begin(), [](unsigned char c) { return std::tolower(c); });
    return "[" + name + "](#" + anchor + ")";
}

/// "number", "[x, y]", "list of [Flight](#flight)", or the words that are allowed.
std::string kindText(const Json& schema) {
    if (schema.contains("$ref")) return linkTo(schema["$ref"]);
    if (schema.contains("anyOf")) {
        std::string text;
        for (const Json& one : schema["anyOf"]) text += (text.empty() ? "" : " or ") + kindText(one);
        return text;
    }
    if (schema.contains("const")) return "`" + schema["const"].dump() + "`";
    if (schema.contains("enum")) {
        std::string text;
        for (const Json& one : schema["enum"]) text += (text.empty() ? "`" : ", `") + one.dump() + "`";
        return text;
    }
    const auto type = schema.value("type", std::string());
    if (type == "string") return "text";
    if (type == "boolean") return "true or false";
    if (type == "integer") return "whole number";
    if (type != "array") return type;
    return schema.contains("maxItems") && schema["maxItems"] == 2 ? "[x, y]" : "list of " + kindText(schema["items"]);
}

/// "> 0", ">= 0, <= 1", "3 to 64 of them".
std::string boundsText(const Json& schema) {
    std::vector<std::string> bounds;
    const auto add = [&](const char* word, const std::string& before, const std::string& after) {
        if (schema.contains(word)) bounds.push_back(before + schema[word].dump() + after);
    };
    const bool isVector = kindText(schema) == "[x, y]";
    if (schema.contains("anyOf")) return boundsText(schema["anyOf"].front());
    if (isVector) {
        if (const std::string each = boundsText(schema["items"]); !each.empty()) bounds.push_back("each " + each);
    } else {
        add("minItems", "at least ", "");
        add("maxItems", "at most ", "");
    }
    add("exclusiveMinimum", "> ", "");
    add("minimum", ">= ", "");
    add("maximum", "<= ", "");
    if (schema.contains("not")) bounds.push_back("not " + schema["not"]["const"].dump());
    if (schema.value("type", std::string()) == "array" && !isVector)
        if (const std::string each = boundsText(schema["items"]); !each.empty()) bounds.push_back("each " + each);
    std::string text;
    for (const std::string& bound : bounds) text += (text.empty() ? "" : ", ") + bound;
    return text;
}

std::string defaultText(const Json& object, const std::string& name, const Json& schema) {
    if (schema.contains("default")) return schema["default"].is_null() ? "none" : "`" + schema["default"].dump() + "`";
    const auto required = object.find("required");
    const bool needed = required != object.end() && std::ranges::find(*required, Json(name)) != required->end();
    return needed ? "must be given" : "";
}

/// The meaning without the unit, which has a column of its own.
std::string meaningText(const Json& schema) {
    const auto text = schema.value("description", std::string()), unit = schema.value("unit", std::string());
    const std::string end = " [" + unit + "]";
    return text.ends_with(end) ? text.substr(0, text.size() - end.size()) : text;
}

/// Alternatives come after the fields; a file has only one of them.
bool isAlternative(const Json& object, const std::string& name) {
    const auto kinds = object.find("oneOf");
    return kinds != object.end() &&
           std::ranges::any_of(*kinds, [&](const Json& kind) { return kind["required"][0] == name; });
}

std::string tableOf(const Json& object) {
    std::string rows, kinds;
    for (const auto& [name, schema] : object["properties"].items()) {
        if (isAlternative(object, name)) {
            kinds += (kinds.empty() ? "" : ", ") + ("`" + name + "`: ") + kindText(schema);
            continue;
        }
        rows += "| `" + name + "` | " + cell(kindText(schema)) + " | " + cell(schema.value("unit", std::string())) +
                " | " + cell(defaultText(object, name, schema)) + " | " + cell(boundsText(schema)) + " | " +
                cell(meaningText(schema)) + " |\n";
    }
    std::string text;
    if (!rows.empty())
        text += "\n| field | kind | unit | default | bounds | what it is |\n|---|---|---|---|---|---|\n" + rows;
    if (!kinds.empty()) text += "\nOne of " + kinds + ".\n";
    return text;
}

}  // namespace

std::string schemaPage(const Json& schema) {
    std::string page = "# What may stand in a scene's file\n";
    for (const auto& [name, object] : schema["$defs"].items()) {
        page += "\n## " + name + "\n";
        if (object.contains("description")) page += "\n" + object["description"].get<std::string>() + "\n";
        page += tableOf(object);
    }
    page.pop_back();  // the caller ends the last line
    return page;
}

}  // namespace plumb::compare
