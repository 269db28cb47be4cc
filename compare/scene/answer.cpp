// SPDX-License-Identifier: MIT
#include <compare/scene/answer.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include <compare/scene/in_field.h>
#include <compare/scene/named.h>
#include <compare/scene/scene.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {

const std::vector<std::string> broadPhaseNames{"brute", "grid", "sweep", "hierarchy"};

namespace {

const std::vector<std::string> valueNames{"x", "y", "angle", "vx", "vy", "speed", "spin"};  // in the order of BodyValue
const std::vector<std::string> ordinals{"last", "first", "second", "third", "fourth", "fifth"};

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// Reads the words between one pair of braces, one after the other.
class QueryReader {
public:
    QueryReader(const Scene& scene, const std::string& text, const std::string& field)
        : scene_(scene), text_(text), field_(field) {
        std::istringstream stream(text);
        for (std::string word; stream >> word;) words_.push_back(word);
    }

    AnswerQuery read() {
        AnswerQuery query = readQuery();
        if (at_ < words_.size())
            refuse(field_, compare::quoted(words_[at_]) + " in " + compare::quoted(text_) + " is not understood");
        return query;
    }

private:
    using Kind = AnswerQuery::Kind;

    AnswerQuery readQuery() {
        if (takes("metric"))
            return {.kind = Kind::Metric, .name = known(checkableMetrics(scene_), "a metric of this scene")};
        if (takes("gravity")) return {.kind = Kind::Gravity};
        if (takes("field")) return {.kind = Kind::Field, .name = field()};
        if (takes("overlap")) return overlap();
        if (takes("tests")) return {.kind = Kind::Tests, .name = (then("by"), known(broadPhaseNames, "a broad phase"))};
        if (word() == "low" || word() == "high" || word() == "least") return {.kind = Kind::Aim, .aim = aim()};
        if (takes("duration")) return {.kind = Kind::Duration};
        if (takes("period")) return {.kind = Kind::Period, .quantity = (then("of"), quantity())};
        if (takes("largest")) return {.kind = Kind::Largest, .quantity = quantity()};
        if (takes("smallest")) return {.kind = Kind::Smallest, .quantity = quantity()};
        if (takes("time")) return {.kind = Kind::Time, .when = (then("when"), happening({}))};
        if (has(ordinals, word())) {
            const Happening extreme = happening({});
            if (extreme.kind == Happening::Kind::Impact)
                refuse(field_, compare::quoted(text_) + " is no number, as in \"time when " + text_ + "\"");
            return {.quantity = extreme.of, .when = extreme};
        }
        AnswerQuery query;
        if (takes("change"))
            then("of"), query.kind = Kind::Change;
        else if (takes("drop"))
            then("of"), query.kind = Kind::Drop;
        query.quantity = quantity();
        if (takes("at"))
            then("start"), query.when = Happening{.of = query.quantity};
        else if (takes("when") || takes("where"))
            query.when = happening(query.quantity);
        return query;
    }

    /// Of a quantity of its own, or of another one.
    Happening happening(const Reading& other) {
        Happening read;
        if (!has(ordinals, word())) {
            read.of = quantity(other.body);
            return passing(read);
        }
        read.which = ordinal();
        if (takes("impact")) return impact(read, other);
        if (word() != "maximum" && word() != "minimum") {
            read.of = other;
            return passing(read, false);
        }
        read.kind = takes("maximum") ? Happening::Kind::Maximum : (then("minimum"), Happening::Kind::Minimum);
        read.of = takes("of") ? quantity(other.body) : other;
        return read;
    }

    Happening impact(Happening read, const Reading& other) {
        read.kind = Happening::Kind::Impact;
        read.of.body = takes("of") ? known(namesOf(scene_.bodies), "a body") : other.body;
        if (read.of.body.empty()) refuse(field_, compare::quoted(text_) + " does not say of which body");
        return read;
    }

    /// "first returns to 0", "last is above start".
    Happening passing(Happening read, bool hasOrdinal = true) {
        if (hasOrdinal) read.which = ordinal();
        if (takes("returns")) {
            then("to");
            read.kind = Happening::Kind::Returns;
        } else {
            then("is");
            read.kind = takes("above") ? Happening::Kind::IsAbove : (then("below"), Happening::Kind::IsBelow);
        }
        if (!takes("start")) read.level = number();
        return read;
    }

    int ordinal() {
        const std::string name = known(ordinals, "first, second or last");
        return name == "last" ? -1 : static_cast<int>(std::ranges::find(ordinals, name) - ordinals.begin());
    }

    /// body: whose value it is if that is not said; "": it must be said.
    Reading quantity(const std::string& body = "") {
        if (takes("probe")) return {.probe = known(namesOf(scene_.probes), "a probe")};
        const std::string value = known(valueNames, "a value of a body");
        Reading read{.body = body};
        read.value = static_cast<BodyValue>(std::ranges::find(valueNames, value) - valueNames.begin());
        if (takes("of"))
            read.body = known(namesOf(scene_.bodies), "a body");
        else if (body.empty())
            refuse(field_, compare::quoted(text_) + " does not say of which body");
        return read;
    }

    std::string field() {
        if (at_ >= words_.size()) refuse(field_, compare::quoted(text_) + " ends too soon, wanted a field");
        inField(field_, [&] { return numberAt(scene_, words_[at_]); });
        return words_[at_++];
    }

    AnswerQuery overlap() {
        AnswerQuery query{.kind = Kind::Overlap};
        then("of");
        query.bodyA = known(namesOf(scene_.bodies), "a body");
        then("and");
        query.bodyB = known(namesOf(scene_.bodies), "a body");
        if (takes("at")) then("start"), query.when = Happening{};
        return query;
    }

    AimReading aim() {
        AimReading read;
        if (takes("least")) {
            then("speed");
            read.part = AimReading::Part::LeastSpeed;
        } else {
            const bool isLow = takes("low") || !takes("high");
            const bool isAngle = known({"angle", "time"}, "angle or time") == "angle";
            read.part = isAngle ? (isLow ? AimReading::Part::LowAngle : AimReading::Part::HighAngle)
                                : (isLow ? AimReading::Part::LowTime : AimReading::Part::HighTime);
        }
        then("of");
        read.body = known(namesOf(scene_.bodies), "a body");
        then("to");
        read.target = known(namesOf(scene_.bodies), "a body");
        return read;
    }

    std::string word() const { return at_ < words_.size() ? words_[at_] : ""; }

    bool takes(const std::string& wanted) {
        if (word() != wanted) return false;
        ++at_;
        return true;
    }

    void then(const std::string& wanted) {
        if (takes(wanted)) return;
        if (word() == "end") refuse(field_, compare::quoted(text_) + " is read at the end without \"at end\"");
        if (wanted == "start")
            refuse(field_, compare::quoted(word()) + " in " + compare::quoted(text_) +
                               " is no event: a time that is written down is wrong as soon as a value is changed");
        const std::string hint = wanted == "when" ? ", as in \"time when first maximum of y of ball\"" : "";
        refuse(field_, compare::quoted(text_) + " wants " + compare::quoted(wanted) + " there" + hint);
    }

    std::string known(const std::vector<std::string>& names, const std::string& what) {
        if (at_ >= words_.size()) refuse(field_, compare::quoted(text_) + " ends too soon, wanted " + what);
        requireKnown(words_[at_], names, field_, what);
        return words_[at_++];
    }

    double number() {
        double value = 0;
        const std::string word = at_ < words_.size() ? words_[at_++] : "";
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || rest != word.data() + word.size())
            refuse(field_, compare::quoted(word) + " in " + compare::quoted(text_) + " is not a number");
        return value;
    }

    const Scene& scene_;
    const std::string& text_;
    const std::string& field_;  ///< in messages
    std::vector<std::string> words_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<AnswerPart> answerParts(const Scene& scene, const std::string& text, const std::string& field,
                                    Marks marks) {
    std::vector<AnswerPart> parts;
    std::size_t start = 0;
    for (std::size_t open = text.find(marks.open); open != std::string::npos; open = text.find(marks.open, start)) {
        const std::size_t close = text.find(marks.close, open);
        if (close == std::string::npos || text.find(marks.open, open + 1) < close)
            refuse(field, std::string("a ") + marks.open + " is not closed");
        const std::string asked = text.substr(open + 1, close - open - 1);
        parts.push_back({text.substr(start, open - start), asked, answerQuery(scene, asked, field)});
        start = close + 1;
    }
    parts.push_back({.text = text.substr(start)});
    return parts;
}

std::vector<AnswerPart> answerParts(const Scene& scene) {
    return answerParts(scene, scene.answer, "answer");
}

AnswerQuery answerQuery(const Scene& scene, const std::string& text, const std::string& field) {
    return QueryReader(scene, text, field).read();
}

std::string textOf(const Reading& quantity) {
    if (!quantity.probe.empty()) return quantity.probe;
    return valueNames[static_cast<std::size_t>(quantity.value)] + " of " + quantity.body;
}

}  // namespace plumb::compare
