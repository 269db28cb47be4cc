// SPDX-License-Identifier: MIT
// What does JavaScript call? Every function of the kit by its number, with a row of numbers, and the rows of all
// bodies, contacts and events at once.
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <web/module/host.h>
#include <web/module/schema_hash.h>
#include <web/module/world_calls.h>
#include <web/runtime/export.h>

namespace plumb::web {

namespace {

std::vector<double> given;   // what JavaScript wrote
std::vector<double> result;  // what it reads
std::string refusal;         // the text of the last error

struct CallTable {
    std::vector<Call> calls = {};

    CallTable() { listAllCalls(*this); }
    template <auto Function>
    void operator()(const char*, const char*, const char*, Fn<Function>) {
        calls.push_back(&call<Function>);
    }
};

/// The number of numbers in the result, or -1 after an error, whose text is then in refusal.
template <class Act>
int tried(Act act) {
    try {
        act();
        return static_cast<int>(result.size());
    } catch (const std::bad_alloc&) {
        refusal = "there is not enough memory";
    } catch (const std::exception& fault) {
        refusal = fault.what();
    }
    return -1;
}

}  // namespace

PLUMB_EXPORT(hashOfSchema) std::uint32_t hashOfSchema() {
    return schemaHash;
}

/// Room for so many numbers; null if there is not enough memory.
PLUMB_EXPORT(room) double* room(std::uint32_t count) {
    return tried([count] { given.resize(count); }) < 0 ? nullptr : given.data();
}

PLUMB_EXPORT(call) int callFunction(std::uint32_t number, std::uint32_t count) {
    static const CallTable table;
    return tried([&] {
        Reader in(std::span(given.data(), count));
        Writer out(result);
        table.calls.at(number)(in, out);
    });
}

/// rows: 0 for poses, 1 for velocities, 2 for contacts, 3 for events.
PLUMB_EXPORT(rowsOf) int rowsOf(WorldHost* host, std::uint32_t rows) {
    return tried([&] { allRows(host->world, static_cast<Rows>(rows), result); });
}

PLUMB_EXPORT(resultAt) const double* resultAt() {
    return result.data();
}
PLUMB_EXPORT(refusalAt) const char* refusalAt() {
    return refusal.data();
}
PLUMB_EXPORT(refusalLength) std::uint32_t refusalLength() {
    return static_cast<std::uint32_t>(refusal.size());
}

}  // namespace plumb::web
