// SPDX-License-Identifier: MIT
#include "house/standard_names.h"

#include <sstream>

namespace plumb::test {

namespace {

struct Row {
    std::string headers, names;  ///< each of the names is in each of the headers
};

const Row rows[] = {
    {"algorithm",
     "sort stable_sort min max minmax clamp find find_if any_of all_of none_of count count_if copy copy_n "
     "fill fill_n transform reverse rotate unique remove remove_if lower_bound upper_bound equal_range "
     "binary_search min_element max_element minmax_element for_each equal nth_element partition "
     "stable_partition is_sorted push_heap pop_heap partial_sort replace search mismatch generate merge"},
    {"any", "any any_cast"},
    {"array", "array"},
    {"atomic", "atomic atomic_ref memory_order_relaxed memory_order_acquire memory_order_release"},
    {"bit", "bit_cast countr_zero countl_zero popcount bit_width bit_ceil has_single_bit rotl rotr endian"},
    {"bitset", "bitset"},
    {"chrono", "chrono"},
    {"cmath",
     "sqrt sin cos tan asin acos atan atan2 exp exp2 expm1 log log2 log10 log1p pow hypot floor ceil round "
     "trunc lround fabs fmod fma isnan isfinite isinf signbit copysign nextafter cbrt remainder sinh cosh "
     "tanh ldexp frexp fmin fmax"},
    {"cmath cstdlib", "abs"},
    {"compare", "strong_ordering weak_ordering partial_ordering"},
    {"complex", "complex"},
    {"concepts",
     "same_as convertible_to invocable integral floating_point derived_from constructible_from predicate "
     "regular"},
    {"condition_variable", "condition_variable"},
    {"cstdint", "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t uintptr_t intptr_t"},
    {"cstdlib", "strtod exit getenv"},
    {"cstring", "memcpy memset memcmp strlen"},
    {"deque", "deque"},
    {"filesystem", "filesystem"},
    {"fstream", "ofstream ifstream fstream"},
    {"functional", "function reference_wrapper ref cref less greater plus invoke"},
    {"future", "future async promise"},
    {"iterator",
     "next prev back_inserter distance advance input_iterator_tag forward_iterator_tag reverse_iterator "
     "bidirectional_iterator_tag random_access_iterator_tag istreambuf_iterator"},
    {"limits", "numeric_limits"},
    {"list", "list"},
    {"map", "map multimap"},
    {"memory", "unique_ptr shared_ptr weak_ptr make_unique make_shared"},
    {"mutex", "mutex lock_guard unique_lock scoped_lock"},
    {"numbers", "numbers"},
    {"numeric", "accumulate iota inner_product partial_sum gcd lcm midpoint"},
    {"optional", "optional nullopt nullopt_t make_optional"},
    {"queue", "queue priority_queue"},
    {"regex", "regex"},
    {"set", "set multiset"},
    {"span", "span"},
    {"sstream", "ostringstream istringstream stringstream"},
    {"stdexcept", "runtime_error invalid_argument logic_error out_of_range"},
    {"string", "string to_string stoi stod getline"},
    {"string_view", "string_view"},
    {"thread", "thread jthread"},
    {"tuple", "tuple tie make_tuple apply"},
    {"type_traits",
     "is_same_v is_same decay_t remove_cvref_t remove_reference_t remove_const_t conditional_t "
     "enable_if_t is_base_of_v is_const_v is_integral_v is_floating_point_v is_enum_v void_t "
     "is_trivially_copyable_v underlying_type_t invoke_result_t is_invocable_v is_invocable_r_v "
     "is_constant_evaluated true_type false_type integral_constant"},
    {"unordered_map", "unordered_map"},
    {"unordered_set", "unordered_set"},
    {"utility", "swap exchange index_sequence make_index_sequence integer_sequence"},
    {"variant", "variant visit get_if holds_alternative monostate variant_size_v variant_alternative_t"},
    {"vector", "vector"},
    // What several have, some of them because their own declarations name it.
    {"exception stdexcept", "exception"},
    {"iosfwd ostream istream iostream sstream fstream", "ostream istream"},
    {"ranges algorithm", "ranges"},
    {"utility map unordered_map", "pair make_pair"},
    {"utility algorithm functional memory map optional string variant vector", "move forward"},
    {"array tuple utility variant", "get"},
    {"array iterator map span string vector", "begin end size data"},
    {"cstddef", "byte nullptr_t"},
    {"cstddef array deque map set span string string_view vector", "ptrdiff_t"},
    {"cstddef cstdio cstdlib cstring array bitset deque functional list map set span string string_view "
     "unordered_map unordered_set variant vector",
     "size_t"},
    {"initializer_list array deque list map set string unordered_map unordered_set vector", "initializer_list"},
    {"functional bitset memory optional string string_view unordered_map unordered_set variant vector", "hash"},
};

}  // namespace

const StandardNames& standardNames() {
    static const StandardNames names = [] {
        StandardNames all;
        for (const Row& row : rows) {
            std::istringstream words(row.names);
            for (std::string name; words >> name;) {
                std::istringstream headers(row.headers);
                for (std::string header; headers >> header;) all[name].push_back(header);
            }
        }
        return all;
    }();
    return names;
}

}  // namespace plumb::test
