// SPDX-License-Identifier: Apache-2.0
// The functions that move lanes, for every instruction set of this machine and every mask, compared with
// plain code.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/lanes_test.cpp"
#include <hwy/foreach_target.h>

#include "simd/bit_matrix-inl.h"
#include "simd/compress-inl.h"
#include "simd/targets.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// The results; columns have room for a vector.
struct Moved {
    int lanes;
    std::vector<double> compressed, expanded, gathered;
    std::vector<std::uint32_t> compressed_numbers;
    std::vector<float> interleaved;
    int set;
    bool same;
};

Moved move_lanes(const double* values, const std::uint32_t* numbers, std::uint32_t bits) {
    Moved m;
    m.lanes = lane_count<double>();
    for (auto* column : {&m.compressed, &m.expanded, &m.gathered}) column->resize(8);
    m.compressed_numbers.resize(8);
    m.interleaved.resize(24);
    const auto mask = from_bits<double>(bits);
    m.set = count(mask);
    compress_store(load(values), mask, m.compressed.data());
    compress_store(numbers, mask, m.compressed_numbers.data());
    store(expand_load(values, mask), m.expanded.data());
    store(gather(values, GatherIndices(numbers, 3)), m.gathered.data());
    m.same = all_same(numbers);
    NarrowFloats a, b, c;
    a.add(load(values));
    b.add(load(values + 8));
    c.add(load(values + 16));
    c.add(iota());
    store_interleaved(a, b, c, m.interleaved.data());
    return m;
}

std::uint64_t matrix_column(const std::uint16_t* rows, int c) {
    BitMatrix matrix;
    std::copy_n(rows, 64, matrix.row);
    return matrix.column(c);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
namespace {

template <class M, class Move> void check(const Move& move) {
    std::vector<double> values(64);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1 / (1.0 + static_cast<double>(i));
    const std::vector<std::uint32_t> numbers{5, 0, 3, 7, 7, 20, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0};
    const std::vector<std::uint32_t> alike(16, 4);
    const int lanes = move(values.data(), numbers.data(), 0u).lanes;
    for (std::uint32_t bits = 0; bits < 1u << lanes; ++bits) {
        const M m = move(values.data(), numbers.data(), bits);
        std::size_t next = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) {
            const bool set = (bits >> i & 1) != 0;
            EXPECT_EQ(m.expanded[i], set ? values[next] : 0) << bits;
            EXPECT_EQ(m.gathered[i], values[3 * numbers[i]]);
            EXPECT_EQ(m.interleaved[3 * i], static_cast<float>(values[i]));
            EXPECT_EQ(m.interleaved[3 * i + 1], static_cast<float>(values[i + 8]));
            EXPECT_EQ(m.interleaved[3 * i + 2], static_cast<float>(values[i + 16]) + static_cast<float>(i));
            if (!set) continue;
            EXPECT_EQ(m.compressed[next], values[i]) << bits;
            EXPECT_EQ(m.compressed_numbers[next], numbers[i]) << bits;
            ++next;
        }
        EXPECT_EQ(m.set, static_cast<int>(next));
        EXPECT_EQ(m.same, lanes == 1);
        EXPECT_TRUE(move(values.data(), alike.data(), bits).same);
    }
}

TEST(Lanes, AreMovedAsInPlainCode) {
    [[maybe_unused]] const auto supported = supported_targets();
#if HWY_TARGETS & HWY_AVX3
    if (supported & HWY_AVX3) check<N_AVX3::Moved>(N_AVX3::move_lanes);
#endif
#if HWY_TARGETS & HWY_AVX2
    if (supported & HWY_AVX2) check<N_AVX2::Moved>(N_AVX2::move_lanes);
#endif
#if HWY_TARGETS & HWY_SSE4
    if (supported & HWY_SSE4) check<N_SSE4::Moved>(N_SSE4::move_lanes);
#endif
#if HWY_TARGETS & HWY_SCALAR
    check<N_SCALAR::Moved>(N_SCALAR::move_lanes);
#endif
}

template <class Column> void check_columns(const Column& column) {
    std::uint16_t rows[64];
    for (std::uint32_t r = 0; r < 64; ++r) rows[r] = static_cast<std::uint16_t>((r + 1) * 40503u >> 3);
    for (int c = 0; c < 16; ++c) {
        std::uint64_t expected = 0;
        for (int r = 0; r < 64; ++r) expected |= std::uint64_t{rows[r] >> c & 1u} << r;
        EXPECT_EQ(column(rows, c), expected) << c;
    }
}

TEST(BitMatrix, ColumnsAreThoseOfPlainCode) {
    [[maybe_unused]] const auto supported = supported_targets();
#if HWY_TARGETS & HWY_AVX3
    if (supported & HWY_AVX3) check_columns(N_AVX3::matrix_column);
#endif
#if HWY_TARGETS & HWY_AVX2
    if (supported & HWY_AVX2) check_columns(N_AVX2::matrix_column);
#endif
#if HWY_TARGETS & HWY_SSE4
    if (supported & HWY_SSE4) check_columns(N_SSE4::matrix_column);
#endif
#if HWY_TARGETS & HWY_SCALAR
    check_columns(N_SCALAR::matrix_column);
#endif
}

// The library's own check: a missing target would be slower, an additional one would crash.
TEST(Lanes, InstructionSetsAreThoseThatHighwayFinds) {
    constexpr std::int64_t known = HWY_AVX3 | HWY_AVX2 | HWY_SSE4;
    EXPECT_EQ(supported_targets() & known, hwy::SupportedTargets() & known);
}

}  // namespace
}  // namespace glint
#endif
