// SPDX-License-Identifier: MIT
#include <compare/scene/answer.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include <compare/scene/metric_names.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

const std::vector<std::string> valueNames{"x", "y", "angle", "vx", "vy", "speed", "spin"};  // in the order of BodyValue

/// Reads the words between one pair of braces, one after the other.
class QueryReader {
public:
    QueryReader(const Scene& scene, const std::string& text) : scene_(scene), text_(text) {
        std::istringstream stream(text);
        for (std::string word; stream >> word;) words_.push_back(word);
    }

    AnswerQuery read() {
        AnswerQuery query;
        query.pick = pick();
        if (takes("metric")) {
            query.kind = AnswerQuery::Kind::Metric;
            query.name = known(checkableMetrics(scene_), "a metric of this scene");
        } else if (takes("probe")) {
            query.kind = AnswerQuery::Kind::Probe;
            query.name = known(namesOf(scene_.probes), "a probe");
        } else {
            const std::string value = known(valueNames, "a value of a body");
            query.value = static_cast<BodyValue>(std::ranges::find(valueNames, value) - valueNames.begin());
            if (!takes("of")) refuse("answer", compare::quoted(text_) + " does not say of which body");
            query.name = known(namesOf(scene_.bodies), "a body");
        }
        if (query.pick == Pick::Last && takes("at")) {
            query.pick = Pick::At;
            query.time = number();
        }
        if (at_ < words_.size())
            refuse("answer", compare::quoted(words_[at_]) + " in " + compare::quoted(text_) + " is not understood");
        return query;
    }

private:
    bool takes(const std::string& word) {
        if (at_ >= words_.size() || words_[at_] != word) return false;
        ++at_;
        return true;
    }

    Pick pick() {
        if (takes("largest")) return Pick::Largest;
        if (takes("smallest")) return Pick::Smallest;
        if (takes("change")) return then("of", Pick::Change);
        if (takes("drop")) return then("of", Pick::Drop);
        if (!takes("time")) return Pick::Last;
        takes("of");
        return takes("smallest") ? Pick::TimeOfSmallest : then("largest", Pick::TimeOfLargest);
    }

    Pick then(const std::string& word, Pick pick) {
        if (!takes(word)) refuse("answer", compare::quoted(text_) + " wants " + compare::quoted(word) + " there");
        return pick;
    }

    std::string known(const std::vector<std::string>& names, const std::string& what) {
        if (at_ >= words_.size()) refuse("answer", compare::quoted(text_) + " ends too soon, wanted " + what);
        requireKnown(words_[at_], names, "answer", what);
        return words_[at_++];
    }

    double number() {
        double value = 0;
        const std::string word = at_ < words_.size() ? words_[at_++] : "";
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || rest != word.data() + word.size() || !(value >= 0))
            refuse("answer", compare::quoted(word) + " in " + compare::quoted(text_) + " is not a time in seconds");
        return value;
    }

    const Scene& scene_;
    const std::string& text_;
    std::vector<std::string> words_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<AnswerPart> answerParts(const Scene& scene) {
    std::vector<AnswerPart> parts;
    const std::string& text = scene.answer;
    std::size_t start = 0;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', start)) {
        const std::size_t close = text.find('}', open);
        if (close == std::string::npos) refuse("answer", "a { is not closed");
        const std::string inside = text.substr(open + 1, close - open - 1);
        parts.push_back({text.substr(start, open - start), QueryReader(scene, inside).read()});
        start = close + 1;
    }
    parts.push_back({text.substr(start), {}});
    return parts;
}

}  // namespace plumb::compare
