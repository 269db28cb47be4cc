// SPDX-License-Identifier: MIT
#include "house/header_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "house/standard_names.h"

namespace plumb::test {

namespace {

using NameSet = std::set<std::string>;

bool isWordPart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Behind the next such word; the end where there is none.
std::size_t after(std::string_view word, std::string_view text, std::size_t from) {
    const std::size_t found = text.find(word, from);
    return found == std::string_view::npos ? text.size() : found + word.size();
}

/// Up to after the quote that closes the one at `open`; R"( and )" as well.
std::size_t afterQuoted(std::string_view text, std::size_t open) {
    if (text[open] == '"' && open > 0 && text[open - 1] == 'R') {
        const std::size_t bracket = text.find('(', open);
        const std::string closing = ")" + std::string(text.substr(open + 1, bracket - open - 1)) + "\"";
        return after(closing, text, bracket);
    }
    std::size_t i = open + 1;
    while (i < text.size() && text[i] != text[open]) i += text[i] == '\\' ? 2u : 1u;
    return i + 1;
}

/// Words, and signs one by one; "::" and "->" are one.
std::vector<std::string> tokensOf(std::string_view code) {
    std::vector<std::string> tokens;
    for (std::size_t i = 0; i < code.size();) {
        std::size_t end = i + 1;
        if (isWordPart(code[i]))
            while (end < code.size() && isWordPart(code[end])) ++end;
        else if (code.substr(i, 2) == "::" || code.substr(i, 2) == "->")
            ++end;
        if (std::isspace(static_cast<unsigned char>(code[i])) == 0) tokens.emplace_back(code.substr(i, end - i));
        i = end;
    }
    return tokens;
}

using Tokens = std::vector<std::string>;

const std::string& at(const Tokens& tokens, std::size_t i) {
    static const std::string none;
    return i < tokens.size() ? tokens[i] : none;
}

bool isOneOf(const std::string& token, std::initializer_list<std::string_view> all) {
    return std::find(all.begin(), all.end(), token) != all.end();
}

/// After the bracket that closes the one at i.
std::size_t afterBracket(const Tokens& tokens, std::size_t i, const std::string& open, const std::string& close) {
    int depth = 0;
    for (; i < tokens.size(); ++i) {
        if (tokens[i] == open) ++depth;
        if (tokens[i] == close && --depth == 0) return i + 1;
    }
    return i;
}

/// Where a name stands that is declared at i, by struct, class, enum or using, or as a template's parameter; 0: none.
std::size_t nameDeclaredAt(const Tokens& tokens, std::size_t i) {
    if (!isOneOf(tokens[i], {"struct", "class", "enum", "using", "concept", "typename"})) return 0;
    std::size_t name = i + 1;
    if (tokens[i] == "enum" && isOneOf(at(tokens, name), {"class", "struct"})) ++name;
    if (at(tokens, name) == "alignas") name = afterBracket(tokens, name + 1, "(", ")");
    while (at(tokens, name) == ".") ++name;  // class... Parts
    if (at(tokens, name).empty() || !isWordPart(at(tokens, name)[0])) return 0;
    if (tokens[i] == "using" && at(tokens, name + 1) != "=") return 0;
    return isOneOf(at(tokens, name + 1), {"::", "<"}) ? 0 : name;  // of another's scope; one kind of a template
}

/// "struct A;", "enum class B : int;"
bool isAnnouncedOnly(const Tokens& tokens, std::size_t name) {
    while (name < tokens.size() && !isOneOf(tokens[name], {";", "{", "="})) ++name;
    return at(tokens, name) == ";";
}

/// What a brace at i opens: the level of namespaces goes on in namespaces only.
bool opensNamespace(const Tokens& tokens, std::size_t i) {
    while (i > 0 && (at(tokens, i - 1) == "::" || isWordPart(at(tokens, i - 1)[0]))) {
        --i;
        if (tokens[i] == "namespace") return true;
    }
    return false;
}

class Includes {
public:
    explicit Includes(const std::vector<SourceFile>& headers) {
        for (const SourceFile& header : headers)
            for (const std::string& include : includesOf(header.text)) direct_[header.path].push_back(include);
    }

    /// The header, all that it includes, and all that those do.
    NameSet from(const std::string& path) const {
        NameSet found;
        std::vector<std::string> open{path};
        while (!open.empty()) {
            const std::string next = open.back();
            open.pop_back();
            const auto more = direct_.find(next);
            if (found.insert(next).second && more != direct_.end())
                open.insert(open.end(), more->second.begin(), more->second.end());
        }
        return found;
    }

private:
    std::map<std::string, std::vector<std::string>> direct_;
};

/// The names that a header uses as types: not as members, enumerators, or of other namespaces.
NameSet typesNamedIn(std::string_view code) {
    const Tokens tokens = tokensOf(code);
    NameSet names;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] == "enum") {
            while (i < tokens.size() && tokens[i] != "{" && tokens[i] != ";") ++i;
            if (at(tokens, i) == "{") i = afterBracket(tokens, i, "{", "}") - 1;
            continue;
        }
        if (i > 0 && isOneOf(tokens[i - 1], {".", "->"})) continue;
        const std::string scope = i > 1 && tokens[i - 1] == "::" ? tokens[i - 2] : "plumb";
        if (isOneOf(scope, {"plumb", "detail", "games", "compare"})) names.insert(tokens[i]);
    }
    return names;
}

}  // namespace

std::string codeOf(std::string_view text) {
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        const bool lineStart =
            code.find_last_not_of(" \t") == std::string::npos || code[code.find_last_not_of(" \t")] == '\n';
        if (text.substr(i, 2) == "//" || (text[i] == '#' && lineStart)) {
            i = std::min(text.size(), text.find('\n', i));
        } else if (text.substr(i, 2) == "/*") {
            i = after("*/", text, i + 2);
        } else if (text[i] == '"' || (text[i] == '\'' && (i == 0 || !isWordPart(text[i - 1])))) {
            i = afterQuoted(text, i);
            code += " 0 ";
        } else {
            code += text[i++];
        }
    }
    return code;
}

DeclaredTypes typesIn(std::string_view code) {
    const Tokens tokens = tokensOf(code);
    DeclaredTypes types;
    std::vector<bool> namespaces;  // of each brace that is open
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] == "{") namespaces.push_back(opensNamespace(tokens, i));
        if (tokens[i] == "}" && !namespaces.empty()) namespaces.pop_back();
        const bool inside = std::find(namespaces.begin(), namespaces.end(), false) != namespaces.end();
        if (tokens[i] == "template") {
            const std::size_t end = afterBracket(tokens, i + 1, "<", ">");
            for (++i; i + 1 < end; ++i)
                if (const std::size_t name = nameDeclaredAt(tokens, i); name != 0 && name < end)
                    types.within.push_back(tokens[name]);
            continue;
        }
        const std::size_t name = nameDeclaredAt(tokens, i);
        if (name == 0) continue;
        if (inside)
            types.within.push_back(tokens[name]);
        else if (isAnnouncedOnly(tokens, name))
            types.announced.push_back(tokens[name]);
        else
            types.defined.push_back(tokens[name]);
        i = name;
    }
    return types;
}

std::vector<std::string> missingStandardHeaders(const std::vector<SourceFile>& headers) {
    const Includes includes(headers);
    std::vector<std::string> faults;
    for (const SourceFile& header : headers) {
        const Tokens tokens = tokensOf(codeOf(header.text));
        const NameSet there = includes.from(header.path);
        NameSet named;
        for (std::size_t i = 2; i < tokens.size(); ++i)
            if (tokens[i - 2] == "std" && tokens[i - 1] == "::") named.insert(tokens[i]);
        for (const std::string& name : named) {
            const auto found = standardNames().find(name);
            if (found == standardNames().end()) continue;
            const std::vector<std::string>& any = found->second;
            if (std::none_of(any.begin(), any.end(), [&](const auto& each) { return there.contains(each); }))
                faults.push_back(header.path + " uses std::" + name + " without <" + any.front() + ">");
        }
    }
    return faults;
}

std::vector<std::string> missingHeaders(const std::vector<SourceFile>& headers) {
    const Includes includes(headers);
    std::map<std::string, NameSet> definedIn;
    std::map<std::string, NameSet> declaredBy, own;  // for who includes a header, and for itself
    for (const SourceFile& header : headers) {
        const DeclaredTypes types = typesIn(codeOf(header.text));
        for (const std::string& name : types.defined) definedIn[name].insert(header.path);
        for (const auto* names : {&types.defined, &types.announced})
            declaredBy[header.path].insert(names->begin(), names->end());
        own[header.path].insert(types.within.begin(), types.within.end());
    }
    std::vector<std::string> faults;
    for (const SourceFile& header : headers) {
        const NameSet there = includes.from(header.path);
        for (const std::string& name : typesNamedIn(codeOf(header.text))) {
            const auto found = definedIn.find(name);
            if (found == definedIn.end() || found->second.size() != 1 || own[header.path].contains(name)) continue;
            const auto has = [&](const std::string& each) {
                const auto names = declaredBy.find(each);
                return names != declaredBy.end() && names->second.contains(name);
            };
            if (std::none_of(there.begin(), there.end(), has))
                faults.push_back(header.path + " names " + name + ", of " + *found->second.begin());
        }
    }
    return faults;
}

}  // namespace plumb::test
