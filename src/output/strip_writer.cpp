// SPDX-License-Identifier: Apache-2.0
#include "output/strip_writer.h"

#include <algorithm>
#include <utility>

namespace glint {

StripWriter::StripWriter(std::unique_ptr<FileInProgress> file, const EncodeOptions& encoding,
                         std::int32_t width, std::int32_t height, bool alpha)
    : file_(std::move(file)), encoder_(make_strip_encoder(width, height, encoding, *file_, alpha)) {}

void StripWriter::put(std::int32_t strip, std::span<const float> values) {
    EncodedStrip encoded = encoder_->encode(strip, values);
    const std::scoped_lock lock(mutex_);
    waiting_.emplace(strip, std::move(encoded));
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
        encoder_->append(std::move(waiting_.begin()->second));
        waiting_.erase(waiting_.begin());
        ++next_;
    }
}

void StripWriter::finish(bool durable) {
    encoder_->finish();
    file_->commit(durable);
}

Crop strip_area(const Crop& picture, std::int32_t strip) {
    const std::int32_t first = strip * k_strip_rows;
    return {picture.width, std::min(k_strip_rows, picture.height - first), picture.x, picture.y + first};
}

}  // namespace glint
