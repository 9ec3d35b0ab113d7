// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures with the numbers of their files: bytes take a quarter of the memory of floats.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "glint/image.h"

namespace glint {

/// As Image, or with whole numbers n as channels, which stand for n / most.
struct StoredPicture {
    std::int32_t width = 0, height = 0;
    std::uint32_t most = 255;
    std::variant<std::vector<float>, std::vector<std::uint8_t>, std::vector<std::uint16_t>> rgb;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    std::size_t bytes() const {
        return std::visit([](const auto& numbers) { return numbers.size() * sizeof(numbers[0]); }, rgb);
    }
    /// Sets the channels of row y, of numbers or of floats. Floats cannot be stored as whole numbers.
    template <class Number> void put_row(std::int32_t y, const Number* row) {
        const std::size_t count = 3 * static_cast<std::size_t>(width),
                          first = count * static_cast<std::size_t>(y);
        if (auto* same = std::get_if<std::vector<Number>>(&rgb)) {
            std::copy_n(row, count, same->begin() + static_cast<std::ptrdiff_t>(first));
        } else if (auto* floats = std::get_if<std::vector<float>>(&rgb)) {
            const auto one = static_cast<float>(most);
            for (std::size_t i = 0; i < count; ++i) (*floats)[first + i] = static_cast<float>(row[i]) / one;
        }
    }
};

/// A picture to be read, which something else holds.
class PictureView {
  public:
    PictureView(const Image& image) : width(image.width), height(image.height), rgb_(std::span(image.rgb)) {}
    PictureView(const StoredPicture& picture)
        : width(picture.width), height(picture.height), most_(picture.most) {
        std::visit([this](const auto& rgb) { rgb_ = std::span(rgb); }, picture.rgb);
    }
    /// Channels n that stand for n / 255.
    PictureView(std::int32_t w, std::int32_t h, std::span<const std::uint8_t> bytes)
        : width(w), height(h), rgb_(bytes) {}
    PictureView(std::int32_t w, std::int32_t h, std::span<const float> floats)
        : width(w), height(h), rgb_(floats) {}

    std::int32_t width, height;

    /// The number of channels that are stored.
    std::size_t size() const {
        return std::visit([](const auto& rgb) { return rgb.size(); }, rgb_);
    }
    bool has_floats() const { return std::holds_alternative<std::span<const float>>(rgb_); }
    /// The bytes, if the channels are n / 255; else none.
    std::span<const std::uint8_t> bytes() const {
        const auto* bytes = std::get_if<std::span<const std::uint8_t>>(&rgb_);
        return bytes != nullptr && most_ == 255 ? *bytes : std::span<const std::uint8_t>();
    }
    /// `count` channels from `first` on: where they are stored, or copied to `buffer`.
    const float* values(std::size_t first, std::size_t count, float* buffer) const {
        if (const auto* floats = std::get_if<std::span<const float>>(&rgb_)) return floats->data() + first;
        if (const auto* bytes = std::get_if<std::span<const std::uint8_t>>(&rgb_))
            return convert(bytes->data() + first, count, buffer);
        return convert(std::get<std::span<const std::uint16_t>>(rgb_).data() + first, count, buffer);
    }
    /// The channels of row y; `buffer` has 3 width numbers.
    const float* row(std::int32_t y, float* buffer) const {
        const std::size_t count = 3 * static_cast<std::size_t>(width);
        return values(count * static_cast<std::size_t>(y), count, buffer);
    }

  private:
    template <class Number> const float* convert(const Number* from, std::size_t count, float* to) const {
        const auto one = static_cast<float>(most_);
        for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]) / one;
        return to;
    }

    std::uint32_t most_ = 255;
    std::variant<std::span<const float>, std::span<const std::uint8_t>, std::span<const std::uint16_t>> rgb_;
};

}  // namespace glint
