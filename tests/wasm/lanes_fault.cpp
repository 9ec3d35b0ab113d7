// SPDX-License-Identifier: Apache-2.0
// A module for the tests: the vectors of simd/wasm_vectors-inl.h beside plain code.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "simd/bit_matrix-inl.h"
#include "simd/compress-inl.h"
#include "simd/sample_hash-inl.h"
#include "wasm/api.h"

namespace glint::HWY_NAMESPACE {
namespace {

std::string fault;  // the first operation that differs

template <class T> auto bits_of(T x) {
    return std::bit_cast<std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>>(x);
}
/// The bits of a NaN are not defined.
template <class T> void expect(const char* operation, T found, T expected) {
    const bool same = expected != expected ? found != found : bits_of(found) == bits_of(expected);
    if (!same && fault.empty())
        fault = fmt::format("{}: bits {:#x} instead of {:#x}", operation, bits_of(found), bits_of(expected));
}
template <class T>
void expect_lanes(const char* operation, Lanes<T> found, const T (&expected)[lane_count<T>()]) {
    T lanes[lane_count<T>()];
    store(found, lanes);
    for (int i = 0; i < lane_count<T>(); ++i) expect(operation, lanes[i], expected[i]);
}
/// Lane i of the result is f(a[i], b[i]).
template <class T, class F>
void expect_each(const char* operation, Lanes<T> found, const T* a, const T* b, const F& f) {
    T expected[lane_count<T>()];
    for (int i = 0; i < lane_count<T>(); ++i) expected[i] = f(a[i], b[i]);
    expect_lanes(operation, found, expected);
}
template <class T, class F>
void expect_mask(const char* operation, LaneMask<T> found, const T* a, const T* b, const F& f) {
    std::uint32_t bits = 0;
    for (int i = 0; i < lane_count<T>(); ++i) bits |= (f(a[i], b[i]) ? 1u : 0u) << i;
    expect(operation, static_cast<double>(to_bits(found)), static_cast<double>(bits));
}

template <class T> void check_arithmetic(const T* a, const T* b) {
    const auto x = load(a), y = load(b);
    expect_each("+", x + y, a, b, [](T p, T q) { return p + q; });
    expect_each("-", x - y, a, b, [](T p, T q) { return p - q; });
    expect_each("*", x * y, a, b, [](T p, T q) { return p * q; });
    expect_each("/", x / y, a, b, [](T p, T q) { return p / q; });
    expect_each("negative", -x, a, b, [](T p, T) { return -p; });
    expect_each("abs", abs(x), a, b, [](T p, T) { return std::abs(p); });
    expect_each("sqrt", sqrt(x), a, b, [](T p, T) { return std::sqrt(p); });
    expect_each("min", min(x, y), a, b, [](T p, T q) { return p < q ? p : q; });
    expect_each("max", max(x, y), a, b, [](T p, T q) { return p < q ? q : p; });
    expect_each("select", select(x < y, x, y), a, b, [](T p, T q) { return p < q ? p : q; });
    expect_mask("<", x < y, a, b, [](T p, T q) { return p < q; });
    expect_mask("<=", x <= y, a, b, [](T p, T q) { return p <= q; });
    expect_mask(">", x > y, a, b, [](T p, T q) { return p > q; });
    expect_mask(">=", x >= y, a, b, [](T p, T q) { return p >= q; });
    expect_mask("==", x == y, a, b, [](T p, T q) { return p == q; });
    expect_mask("!", !(x < y), a, b, [](T p, T q) { return !(p < q); });
    expect_mask("&&", x < y && x >= Lanes<T>(0), a, b, [](T p, T q) { return p < q && p >= 0; });
    expect_mask("||", x < y || x >= Lanes<T>(0), a, b, [](T p, T q) { return p < q || p >= 0; });
    expect_mask("and_not", and_not(x < y, x >= Lanes<T>(0)), a, b,
                [](T p, T q) { return p < q && !(p >= 0); });
}

template <class T> void check_masks(const T* a) {
    constexpr int lanes = lane_count<T>();
    for (std::uint32_t bits = 0; bits < 1u << lanes; ++bits) {
        const auto mask = from_bits<T>(bits);
        expect<double>("from_bits", to_bits(mask), bits);
        expect<double>("count", count(mask), __builtin_popcount(bits));
        expect<double>("any", any(mask), bits != 0);
        expect<double>("all", all(mask), bits == first_bits(lanes));
    }
    for (int n = 0; n <= lanes + 1; ++n)
        expect<double>("first_lanes", to_bits(first_lanes<T>(n)), first_bits(n < lanes ? n : lanes));
    T most = a[0];
    for (int i = 1; i < lanes; ++i) most = a[i] > most ? a[i] : most;
    expect("max_of_lanes", max_of_lanes(load(a)), most);
}

void check_moves(const double* a) {
    const std::uint32_t numbers[4] = {5, 0, 3, 3};
    expect_lanes("gather", gather(a, GatherIndices(numbers, 3)), {a[15], a[0]});
    float singles[16];
    for (int i = 0; i < 16; ++i) singles[i] = static_cast<float>(i) / 3;
    expect_lanes("gather of floats", gather(singles, SingleGatherIndices(numbers, 3)),
                 {double{singles[15]}, double{singles[0]}});
    expect_lanes("widen", widen(singles + 1), {double{singles[1]}, double{singles[2]}});
    expect("min_of_lanes", min_of_lanes(load(singles + 4)), singles[4]);
    expect<double>("all_same", all_same(numbers), 0);
    expect<double>("all_same", all_same(numbers + 2), 1);
    for (std::uint32_t bits = 0; bits < 4; ++bits) {
        const auto mask = from_bits<double>(bits);
        double packed[2] = {};
        compress_store(load(a), mask, packed);
        const double first = (bits & 1) != 0 ? a[0] : a[1];
        if (bits != 0) expect("compress_store", packed[0], first);
        if (bits == 3) expect("compress_store", packed[1], a[1]);
        const double expanded[2] = {(bits & 1) != 0 ? a[0] : 0, bits == 3 ? a[1] : bits == 2 ? a[0] : 0};
        expect_lanes("expand_load", expand_load(a, mask), expanded);
        std::uint32_t words[2] = {7, 8};
        store_where(bits, 9, words);
        expect<double>("store_where", words[0], (bits & 1) != 0 ? 9 : 7);
        expect<double>("store_where", words[1], (bits & 2) != 0 ? 9 : 8);
    }
    float narrow[6];
    NarrowFloats p, q, r;
    p.add(load(a)), q.add(load(a + 2)), r.add(iota());
    store_interleaved(p, q, r, narrow);
    for (int i = 0; i < 2; ++i) {
        expect("store_interleaved", narrow[3 * i], static_cast<float>(a[i]));
        expect("store_interleaved", narrow[3 * i + 1], static_cast<float>(a[i + 2]));
        expect("store_interleaved", narrow[3 * i + 2], static_cast<float>(i));
    }
    std::int32_t ordered[4];
    store_ordered_bits(-load(singles), ordered);
    for (int i = 0; i < 4; ++i) expect<double>("store_ordered_bits", ordered[i], ordered_bits(-singles[i]));
}

void check_bits() {
    BitMatrix matrix;
    for (std::uint32_t r = 0; r < 64; ++r) matrix.row[r] = static_cast<std::uint16_t>((r + 1) * 40503u >> 3);
    for (int c = 0; c < 16; ++c) {
        std::uint64_t expected = 0;
        for (int r = 0; r < 64; ++r) expected |= std::uint64_t{matrix.row[r] >> c & 1u} << r;
        if (matrix.column(c) != expected && fault.empty()) fault = "BitMatrix::column";
    }
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const std::uint32_t x[2] = {i * 2654435761u, ~i * 40503u};
        const double numbers[2] = {double(x[0]), double(x[1])};
        const Words words = to_words(load(numbers));
        expect_lanes("words", to_doubles((words ^ (words >> 13)) * 0x7feb352du),
                     {double((x[0] ^ x[0] >> 13) * 0x7feb352du), double((x[1] ^ x[1] >> 13) * 0x7feb352du)});
    }
    const double numbers[2] = {-1.75e300, 3e-200};
    for (const double x : numbers) {
        Doubles mantissa;
        const Doubles exponent = split_exponent(Doubles(std::abs(x)), mantissa);
        int e = 0;
        const double m = 2 * std::frexp(std::abs(x), &e);
        expect_lanes("split_exponent", mantissa, {m, m});
        expect_lanes("exp2_integer", exp2_integer(exponent),
                     {std::ldexp(1.0, e - 1), std::ldexp(1.0, e - 1)});
        const double high = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000u);
        expect_lanes("head", head(Doubles(x)), {high, high});
    }
}

template <class T> void check_numbers() {
    constexpr T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    constexpr T tiny = std::numeric_limits<T>::denorm_min();
    const T values[] = {0, T(-0.0), 1, -1, T(0.1), T(-1e30), tiny, -tiny, infinity, -infinity, nan, T(3.5)};
    for (const T p : values) {
        for (const T q : values) {
            const T a[4] = {p, q, T(0.25), T(-7)}, b[4] = {q, p, T(7), T(-0.1)};
            check_arithmetic(a, b);
        }
    }
    const T apart[4] = {1, 4, -3, 7};
    check_masks(apart);
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE

extern "C" {

/// The first operation that differs from plain code, with both results; empty if none does.
const char* GLINT_WASM_EXPORT(lanes_fault)() {
    using namespace glint::HWY_NAMESPACE;
    fault.clear();
    check_numbers<float>();
    check_numbers<double>();
    double values[24];
    for (int i = 0; i < 24; ++i) values[i] = 1 / (1.0 + i);
    check_moves(values);
    check_bits();
    return fault.c_str();
}

}  // extern "C"
