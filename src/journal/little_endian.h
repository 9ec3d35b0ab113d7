// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers in a journal: little-endian, whatever the machine is.
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace glint {

template <class T> void put_bytes(std::string& bytes, T value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}
inline void put_u32(std::string& bytes, std::uint32_t value) { put_bytes(bytes, value); }
inline void put_u64(std::string& bytes, std::uint64_t value) { put_bytes(bytes, value); }
inline void put_float(std::string& bytes, float value) {
    put_u32(bytes, std::bit_cast<std::uint32_t>(value));
}

/// `bytes` must have as many as the number.
template <class T> T get_bytes(std::string_view bytes) {
    T value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
        value |= static_cast<T>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return value;
}
inline std::uint32_t get_u32(std::string_view bytes) { return get_bytes<std::uint32_t>(bytes); }
inline std::uint64_t get_u64(std::string_view bytes) { return get_bytes<std::uint64_t>(bytes); }
inline float get_float(std::string_view bytes) { return std::bit_cast<float>(get_u32(bytes)); }

}  // namespace glint
