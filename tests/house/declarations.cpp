// SPDX-License-Identifier: MIT
#include "house/declarations.h"

#include <algorithm>
#include <regex>

namespace plumb::test {

namespace {

std::string withoutComments(std::string_view header) {
    static const std::regex comment(R"(//[^\n]*|/\*[\s\S]*?\*/|(^|\n)#[^\n]*)");
    return std::regex_replace(std::string(header), comment, "\n");
}

/// Up to the bracket that closes the one at `open`.
std::size_t closing(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        if (text[i] == '{' || text[i] == '(') ++depth;
        if ((text[i] == '}' || text[i] == ')') && --depth == 0) return i;
    }
    return text.size();
}

/// A declaration: what stands before its body, if it has one, and the body without its brackets.
struct Piece {
    std::string head, body;
};

bool endsWithoutSemicolon(const std::string& head) {
    static const std::regex type(R"(^(template\s*<[^;]*>\s*)?(struct|class|enum)\b)");
    return head.find('(') != std::string::npos || head.starts_with("namespace") ||
           (head.starts_with("struct") && !std::regex_search(head, type));
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \n\t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \n\t") - first + 1);
}

std::vector<Piece> piecesOf(const std::string& text) {
    std::vector<Piece> pieces;
    Piece piece;
    const auto finish = [&] {
        piece.head = trimmed(piece.head);
        if (!piece.head.empty()) pieces.push_back(piece);
        piece = {};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') {
            const std::size_t end = closing(text, i);
            piece.head += text.substr(i, end - i + 1);
            i = end;
        } else if (text[i] == '{') {
            const std::size_t end = closing(text, i);
            piece.body = text.substr(i + 1, end - i - 1);
            i = end;
            if (endsWithoutSemicolon(trimmed(piece.head))) finish();
        } else if (text[i] == ';') {
            finish();
        } else if (text[i] == ':' && (trimmed(piece.head) == "public" || trimmed(piece.head) == "private" ||
                                      trimmed(piece.head) == "protected")) {
            finish();
        } else {
            piece.head += text[i];
        }
    }
    return pieces;
}

/// At commas that are not within brackets of any kind.
std::vector<std::string> splitAtCommas(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : text) {
        if (c == '{' || c == '(' || c == '<') ++depth;
        if (c == '}' || c == ')' || c == '>') --depth;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// The last word before any initial value.
std::string nameIn(const std::string& declarator) {
    static const std::regex last(R"(([A-Za-z_]\w*)\s*$)");
    const std::string before = declarator.substr(0, declarator.find_first_of("={"));
    std::smatch match;
    return std::regex_search(before, match, last) ? match[1].str() : std::string();
}

void add(Names& names, const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

bool isLeftOut(const std::string& head) {
    static const std::regex left(R"(^(friend|using|static|enum|return|extern)\b|\boperator\b)");
    return std::regex_search(head, left) || head.find("constexpr") != std::string::npos;
}

void addFunction(Declarations& all, const std::string& head, const std::string& scope) {
    const std::size_t open = head.find('(');
    const std::string before = trimmed(head.substr(0, open));
    if (before.find(' ') == std::string::npos) return;  // a constructor
    const std::string parameters = head.substr(open + 1, closing(head, open) - open - 1);
    const std::string name = nameIn(before);
    if (name.empty() || before.ends_with("::" + name)) return;  // of what is declared elsewhere
    Names& names = all.functions[scope.empty() ? name : scope + "." + name];
    for (const std::string& parameter : splitAtCommas(parameters)) add(names, nameIn(parameter));
}

void addScope(Declarations& all, const std::string& text, const std::string& scope, bool isClass);

void addPiece(Declarations& all, const Piece& piece, const std::string& scope, bool isClass) {
    static const std::regex type(
        R"(^(?:template\s*<[\s\S]*>\s*)?(struct|class)\s+(?:alignas\(\d+\)\s*)?([A-Za-z_]\w*))");
    std::smatch match;
    if (piece.head.starts_with("namespace")) return addScope(all, piece.body, scope, false);
    if (std::regex_search(piece.head, match, type)) {
        if (piece.body.empty()) return;                      // only announced
        if (match.suffix().str().starts_with("::")) return;  // another's template
        const std::string name = scope.empty() ? match[2].str() : scope + "." + match[2].str();
        const bool inner = match[1] == "class";
        (inner ? all.classes : all.structs)[name];
        return addScope(all, piece.body, name, inner);
    }
    if (isLeftOut(piece.head)) return;
    const std::size_t bracket = piece.head.find('(');  // behind '=' it is an initial value's
    if (bracket != std::string::npos && bracket < piece.head.find('=')) return addFunction(all, piece.head, scope);
    if (scope.empty() || isClass) return;
    for (const std::string& part : splitAtCommas(piece.head)) add(all.structs[scope], nameIn(part));
}

void addScope(Declarations& all, const std::string& text, const std::string& scope, bool isClass) {
    bool isPublic = !isClass;
    for (const Piece& piece : piecesOf(text)) {
        if (piece.head == "public" || piece.head == "private" || piece.head == "protected")
            isPublic = piece.head == "public";
        else if (isPublic)
            addPiece(all, piece, scope, isClass);
    }
}

}  // namespace

void addDeclarations(Declarations& all, std::string_view header) {
    addScope(all, withoutComments(header), "", false);
}

}  // namespace plumb::test
