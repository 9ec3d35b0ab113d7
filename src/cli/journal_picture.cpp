// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/parallel_for.h"
#include "cli/failure.h"
#include "output/strip_writer.h"

namespace glint::cli {

JournalPicture::JournalPicture(const std::vector<JournalInput>& inputs) : inputs_(inputs) {
    tiles_.resize(count_tiles(header().picture));
    std::vector<std::size_t> owners(tiles_.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (const JournalTile& tile : inputs[i].journal.tiles) {
            const JournalTile*& first = tiles_[tile.number];
            if (first == nullptr) {
                first = &tile;
                owners[tile.number] = i;
                ++present_;
            } else if (first->floats != tile.floats) {
                throw Failure(k_bad_input,
                              fmt::format("tile {} differs between {} and {}: they were not rendered by the "
                                          "same version of glint",
                                          tile.number, inputs[owners[tile.number]].name, inputs[i].name));
            }
        }
    }
    release();
}

void JournalPicture::release() const {
    for (const JournalInput& input : inputs_) input.file.release();
}

std::size_t JournalPicture::channels(std::size_t image) const {
    return image == 0 ? 3 : header().channels_of_layer(image - 1);
}

std::int32_t JournalPicture::strips() const { return count_strips(header().picture.height); }

std::vector<float> JournalPicture::read_strip(std::size_t image, std::int32_t strip) const {
    const Crop area = strip_area(header().picture, strip);
    std::vector<float> values(channels(image) * static_cast<std::size_t>(area.width) *
                              static_cast<std::size_t>(area.height));
    const std::size_t across = tiles_.size() / static_cast<std::size_t>(strips());
    for (std::size_t tile = static_cast<std::size_t>(strip) * across, end = tile + across; tile < end;
         ++tile) {
        if (tiles_[tile] != nullptr) copy_tile(*tiles_[tile], header(), image, area, values.data());
    }
    return values;
}

void JournalPicture::for_each_strip(
    std::size_t image, int threads,
    const std::function<void(std::int32_t, std::span<const float>)>& use) const {
    const std::int32_t step = thread_count(threads);
    for (std::int32_t first = 0; first < strips(); first += step) {
        const auto count = static_cast<std::size_t>(std::min(step, strips() - first));
        std::vector<std::exception_ptr> failures(count);
        parallel_for(count, threads, [&](std::size_t i) {
            try {
                const std::int32_t strip = first + static_cast<std::int32_t>(i);
                use(strip, read_strip(image, strip));
            } catch (...) {
                failures[i] = std::current_exception();
            }
        });
        for (const std::exception_ptr& failure : failures) {
            if (failure) std::rethrow_exception(failure);
        }
        release();
    }
}

Image JournalPicture::image() const {
    const Crop& picture = header().picture;
    Image image{picture.width, picture.height, {}};
    image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(picture.width) *
                     static_cast<std::size_t>(picture.height));
    for (const JournalTile* tile : tiles_) {
        if (tile != nullptr) copy_tile(*tile, header(), 0, picture, image.rgb.data());
    }
    return image;
}

}  // namespace glint::cli
