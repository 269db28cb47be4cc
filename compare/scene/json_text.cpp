// SPDX-License-Identifier: MIT
#include <compare/scene/json_text.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace plumb::compare {
namespace {

/// Goes through a text and records how far it got, because the parser does not give positions.
class TrackedIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    TrackedIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
    const char& operator*() const { return *at_; }
    TrackedIterator& operator++() {
        *reached_ = at_++;
        return *this;
    }
    TrackedIterator operator++(int) {
        TrackedIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const TrackedIterator& other) const { return at_ == other.at_; }
    bool operator!=(const TrackedIterator& other) const { return at_ != other.at_; }

private:
    const char* at_;
    const char** reached_;
};

struct Place {
    int line, column;  ///< from 1; a column is a byte
};

Place placeOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto lineStart = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
    return {1 + static_cast<int>(std::ranges::count(before, '\n')), static_cast<int>(offset - lineStart) + 1};
}

std::string located(const std::string& file, const Place& place, const std::string& what) {
    return file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + onOneLine(what);
}

/// Builds the tree as the parser reports it, and notes the line of every value.
class TreeBuilder : public nlohmann::json_sax<Json> {
public:
    TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file), reached_(text.data()) {}

    JsonText read() {
        const char* end = text_.data() + text_.size();
        Json::sax_parse(TrackedIterator(text_.data(), &reached_), TrackedIterator(end, &reached_), this);
        return std::move(result_);
    }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(value); }
    bool binary(binary_t&) override { return false; }  // never called: text has none
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (open_.back().value->contains(name)) {
            const auto last = static_cast<std::size_t>(reached_ - text_.data());
            const std::size_t start = text_.rfind('"', last - 1);
            throw std::invalid_argument(
                located(file_, placeOf(text_, start), member(open_.back().path, name) + ": given twice, wanted once"));
        }
        key_ = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        std::string what = error.what();
        what = what.substr(what.find("] ") + 2);  // removes the library's own name and number of the error
        if (what.starts_with("parse error at")) what = what.substr(what.find(": ") + 2);
        const std::size_t offset = std::min(position - std::min(position, faultLength(what, token)), text_.size());
        if (const std::size_t read = what.find("; last read: '"); read != std::string::npos) {
            what.erase(read, what.rfind('\'') + 1 - read);  // the position already says it
        }
        throw std::invalid_argument(located(file_, placeOf(text_, offset), what));
    }

private:
    struct Open {
        Json* value;
        std::string path;
    };

    /// How far before the last character read the fault begins: one character that spoils a token, or a whole token in
    /// the wrong place.
    static std::size_t faultLength(const std::string& what, const std::string& token) {
        for (const char* word : {"true", "false", "null"}) {
            if (what.find("unexpected " + std::string(word)) != std::string::npos) return std::strlen(word);
        }
        const bool stringOrNumber = what.find("unexpected string") != std::string::npos ||
                                    what.find("unexpected number") != std::string::npos ||
                                    what.starts_with("number overflow");
        return stringOrNumber ? token.size() : 1;
    }

    static std::string member(const std::string& parent, const std::string& name) {
        return parent.empty() ? name : parent + "." + name;
    }

    /// All text up to the last character read belongs to the value; after a number, one more character has been read.
    /// Line breaks before that character are counted.
    int lineReached() {
        lines_ += static_cast<int>(std::count(counted_, reached_, '\n'));
        counted_ = reached_;
        return lines_;
    }

    /// A pointer to an open array or object stays valid: its parent does not grow before it is closed.
    Open add(Json value) {
        Open added{&result_.root, ""};
        if (!open_.empty()) {
            Json& parent = *open_.back().value;
            added.path = parent.is_array() ? open_.back().path + "[" + std::to_string(parent.size()) + "]"
                                           : member(open_.back().path, key_);
            if (parent.is_array()) parent.push_back(nullptr);
            added.value = parent.is_array() ? &parent.back() : &parent[key_];
        }
        *added.value = std::move(value);
        result_.lines[added.path] = lineReached();
        return added;
    }
    bool put(Json value) {
        add(std::move(value));
        return true;
    }
    bool open(Json value) {
        open_.push_back(add(std::move(value)));
        if (open_.size() <= maxDepth) return true;
        const auto offset = static_cast<std::size_t>(reached_ - text_.data());
        throw std::invalid_argument(
            located(file_, placeOf(text_, offset),
                    "nested " + std::to_string(open_.size()) + " deep, wanted at most " + std::to_string(maxDepth)));
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    static constexpr std::size_t maxDepth = 64;  ///< a scene needs 8; paths of a deeper text could fill the memory

    std::string_view text_;
    const std::string& file_;
    const char* reached_;
    const char* counted_ = text_.data();
    int lines_ = 1;
    JsonText result_;
    std::vector<Open> open_;
    std::string key_;
};

std::string label(const Json& parent, const std::string& name) {
    return parent.is_array() ? "" : Json(name).dump() + ": ";
}

std::string flat(const Json& value) {
    if (!value.is_structured()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string out;
    for (const auto& [name, item] : value.items()) {
        if (!out.empty()) out += ", ";
        out += label(value, name) + flat(item);
    }
    return value.is_array() ? "[" + out + "]" : "{" + out + "}";
}

/// used: how many characters of the line are already used.
std::string formatted(const Json& value, std::size_t indent, std::size_t used) {
    constexpr std::size_t width = 119;  // 120 less one for a comma
    const std::string line = flat(value);
    if (!value.is_structured() || value.empty() || used + line.size() <= width) return line;
    const std::string start = "\n" + std::string(indent + 2, ' ');
    std::string out;
    for (const auto& [name, item] : value.items()) {
        const std::string head = label(value, name);
        out += (out.empty() ? "" : ",") + start + head + formatted(item, indent + 2, indent + 2 + head.size());
    }
    out += "\n" + std::string(indent, ' ');
    return value.is_array() ? "[" + out + "]" : "{" + out + "}";
}

}  // namespace

std::string onOneLine(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

JsonText parseJson(std::string_view text, const std::string& file) {
    return TreeBuilder(text, file).read();
}

std::string formatJson(const Json& value) {
    return formatted(value, 0, 0);
}

}  // namespace plumb::compare
