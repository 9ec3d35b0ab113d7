// SPDX-License-Identifier: Apache-2.0
// The figures of the difference between two pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fp_environment.h"
#include "base/memory_limit.h"
#include "base/parallel_scratch.h"
#include "base/status.h"
#include "glint/compare.h"
#include "image/levels.h"
#include "image/quantize.h"
#include "math/elementary.h"

namespace glint {
namespace {

double decibels(double mean_square) { return 10 * log(255.0 * 255.0 / mean_square) / log(10); }

// The sums of one row.
struct RowSums {
    PixelCounts edges, interiors;
    std::uint64_t not_finite = 0;
    double sum = 0, squares = 0;
    double largest = 0;
    std::int32_t x = 0;
};

// `finite` marks the pixels that are finite in both pictures.
RowSums sum_row(const float* a, const float* b, const std::uint8_t* edges, const std::uint8_t* finite,
                std::int32_t width, double unit, double within) {
    RowSums row;
    for (std::int32_t x = 0; x < width; ++x) {
        double worst = 0;
        for (int c = 0; c < 3; ++c) {
            const double d =
                unit * std::fabs(static_cast<double>(a[3 * x + c]) - static_cast<double>(b[3 * x + c]));
            row.sum += d;
            row.squares += d * d;
            worst = std::max(worst, d);
        }
        PixelCounts& counts = edges[x] != 0 ? row.edges : row.interiors;
        ++counts.pixels;
        row.not_finite += finite[x] == 0;
        counts.equal += finite[x] != 0 && worst == 0;
        counts.within_1 += finite[x] != 0 && worst <= 1;
        counts.within += finite[x] != 0 && worst <= within;
        if (worst > row.largest) {
            row.largest = worst;
            row.x = x;
        }
    }
    return row;
}

void add(PixelCounts& to, const PixelCounts& more) {
    to.pixels += more.pixels;
    to.equal += more.equal;
    to.within_1 += more.within_1;
    to.within += more.within;
}

// The rows that are compared at a time, and what memory that takes: few enough for the cache of a processor.
constexpr std::size_t k_max_rows = 32, k_min_rows = 4, k_strip_bytes = std::size_t{1} << 24;
// By default: beyond the pictures.
constexpr std::uint64_t k_comparing = std::uint64_t{1} << 26, k_comparing_each = 1;

// The memory of one thread.
struct Strip {
    explicit Strip(std::size_t width, std::size_t rows)
        : a(3 * width),
          b(3 * width * (rows + 2)),
          luminance_a(width * rows_with_windows(rows)),
          luminance_b(luminance_a.size()),
          extremes(6 * width),
          columns(width),
          edges(width),
          finite(width) {}

    static std::size_t rows_with_windows(std::size_t rows) { return rows + k_ssim_window - 1; }
    static std::size_t bytes(std::size_t width, std::size_t rows) {
        return width * (3 * sizeof(float) * (rows + 5) + 2 * sizeof(double) * rows_with_windows(rows) +
                        sizeof(SsimMoments) + 2);
    }

    std::vector<float> a, b;  // levels: of a row, and of the strip's rows and those above and below
    std::vector<double> luminance_a, luminance_b;
    std::vector<float> extremes;
    std::vector<SsimMoments> columns;
    std::vector<std::uint8_t> edges, finite;
};

double luminance(const float* rgb) {
    return 0.299 * static_cast<double>(rgb[0]) + 0.587 * static_cast<double>(rgb[1]) +
           0.114 * static_cast<double>(rgb[2]);
}

// Two pictures and their rows in the form in which they are compared: bytes (unit 1), or unchanged floats
// (unit 255); 0 for values that are not finite.
class Measure {
  public:
    Measure(const PictureView& a, const PictureView& b, const CompareOptions& options)
        : a_(a),
          b_(b),
          options_(options),
          width_(static_cast<std::size_t>(b.width)),
          height_(static_cast<std::size_t>(b.height)),
          unit_(options.as_floats ? 255 : 1),
          has_windows_(std::min(b.width, b.height) >= k_ssim_window) {}

    Result<PictureDifference> run() {
        std::size_t rows = k_max_rows;
        while (rows > k_min_rows && Strip::bytes(width_, rows) > k_strip_bytes) rows /= 2;
        const std::uint64_t each = Strip::bytes(width_, rows),
                            whole = height_ * (sizeof(RowSums) + sizeof(double)),
                            allowed = options_.max_memory > 0
                                          ? options_.max_memory
                                          : k_comparing + k_comparing_each * width_ * height_;
        if (Status fault = memory_fault(whole + each, allowed, "comparing the pictures"); !fault.ok())
            return fault;
        const std::size_t strips = (height_ + rows - 1) / rows;
        const std::uint64_t threads =
            std::min<std::uint64_t>(scratch_count(strips, options_.threads), (allowed - whole) / each);
        std::vector<Strip> scratch;
        scratch.reserve(static_cast<std::size_t>(threads));
        while (scratch.size() < threads) scratch.emplace_back(width_, rows);
        rows_.resize(height_);
        similarities_.resize(has_windows_ ? height_ - k_ssim_window + 1 : 0);
        parallel_scratch(strips, scratch, [&](std::size_t i, Strip& strip) {
            measure(i * rows, std::min((i + 1) * rows, height_), strip);
        });
        return sum();
    }

  private:
    void read(const PictureView& picture, std::size_t y, float* out) const {
        const std::size_t count = 3 * width_, first = count * y;
        if (const auto bytes = picture.bytes(); !options_.as_floats && !bytes.empty()) {
            for (std::size_t i = 0; i < count; ++i) out[i] = bytes[first + i];
            return;
        }
        const float* values = picture.values(first, count, out);
        for (std::size_t i = 0; i < count; ++i) {
            const float value = is_finite(values[i]) ? values[i] : 0;
            out[i] =
                options_.as_floats ? value : static_cast<float>(quantize(static_cast<double>(value), 255));
        }
    }

    // `buffer` has 3 width numbers.
    void mark_finite(std::size_t y, float* buffer, std::vector<std::uint8_t>& marks) const {
        std::fill(marks.begin(), marks.end(), std::uint8_t{1});
        for (const PictureView* picture : {&a_, &b_}) {
            if (!picture->has_floats()) continue;
            const float* values = picture->row(static_cast<std::int32_t>(y), buffer);
            for (std::size_t x = 0; x < width_; ++x)
                marks[x] = marks[x] != 0 && is_finite_pixel(values + 3 * x);
        }
    }

    void measure(std::size_t first, std::size_t last, Strip& strip) {
        const std::size_t top = first > 0 ? first - 1 : 0, bottom = std::min(last + 1, height_),
                          end = has_windows_ ? std::min(last + k_ssim_window - 1, height_) : bottom;
        const auto of_b = [&](std::size_t y) { return strip.b.data() + 3 * width_ * (y - top); };
        for (std::size_t y = top; y < bottom; ++y) read(b_, y, of_b(y));
        for (std::size_t y = first; y < std::max(end, last); ++y) {
            float* a = strip.a.data();
            read(a_, y, a);
            if (y < last) {
                mark_edges<float>({of_b(y > 0 ? y - 1 : 0), of_b(y), of_b(std::min(y + 1, height_ - 1))},
                                  b_.width, unit_, strip.extremes.data(), strip.edges.data());
                mark_finite(y, strip.extremes.data(), strip.finite);
                rows_[y] = sum_row(a, of_b(y), strip.edges.data(), strip.finite.data(), b_.width, unit_,
                                   options_.within);
            }
            if (!has_windows_) continue;
            const float* b = of_b(y);
            if (y >= bottom) {
                read(b_, y, strip.extremes.data());
                b = strip.extremes.data();
            }
            const std::size_t to = width_ * (y - first);
            for (std::size_t x = 0; x < width_; ++x) {
                strip.luminance_a[to + x] = unit_ * luminance(a + 3 * x);
                strip.luminance_b[to + x] = unit_ * luminance(b + 3 * x);
            }
        }
        for (std::size_t y = first; y < std::min(last, similarities_.size()); ++y) {
            const std::size_t from = width_ * (y - first);
            similarities_[y] = ssim_.sum_row(&strip.luminance_a[from], &strip.luminance_b[from], b_.width,
                                             strip.columns.data());
        }
    }

    PictureDifference sum() const {
        PictureDifference result;
        double sum = 0, squares = 0;
        for (std::size_t y = 0; y < rows_.size(); ++y) {
            const RowSums& row = rows_[y];
            add(result.edges, row.edges);
            add(result.interiors, row.interiors);
            result.not_finite += row.not_finite;
            sum += row.sum;
            squares += row.squares;
            if (row.largest > result.largest.value) {
                result.largest.value = row.largest;
                result.largest.x = row.x;
                result.largest.y = static_cast<std::int32_t>(y);
            }
        }
        result.all = result.edges;
        add(result.all, result.interiors);
        const double channels = 3 * static_cast<double>(result.all.pixels);
        result.mean = sum / channels;
        result.rms = std::sqrt(squares / channels);
        if (squares > 0) result.psnr = decibels(squares / channels);
        set_colors(a_, result.largest, result.largest.a);
        set_colors(b_, result.largest, result.largest.b);
        if (has_windows_) {
            double whole = 0;
            for (const double row : similarities_) whole += row;
            result.ssim = whole / (static_cast<double>(b_.width - k_ssim_window + 1) *
                                   static_cast<double>(similarities_.size()));
        }
        return result;
    }

    void set_colors(const PictureView& picture, const LargestDifference& at, float (&colors)[3]) const {
        std::vector<float> row(3 * width_);
        read(picture, static_cast<std::size_t>(at.y), row.data());
        for (std::size_t c = 0; c < 3; ++c)
            colors[c] = row[3 * static_cast<std::size_t>(at.x) + c] * static_cast<float>(unit_ / 255);
    }

    const PictureView &a_, &b_;
    const CompareOptions& options_;
    const std::size_t width_, height_;
    const double unit_;  // 255ths per unit of the values
    const bool has_windows_;
    const Ssim ssim_;
    std::vector<RowSums> rows_;
    std::vector<double> similarities_;  // of the windows that begin in a row
};

}  // namespace

std::string pair_fault(const PictureView& a, const PictureView& b) {
    for (const PictureView* image : {&a, &b}) {
        if (image->width < 1 || image->height < 1 ||
            image->size() != std::size_t{3} * image->width * image->height) {
            return "a picture without pixels, or whose numbers do not fit its size";
        }
    }
    if (a.width == b.width && a.height == b.height) return {};
    return fmt::format("the pictures have different sizes: {}x{} and {}x{}{}", a.width, a.height, b.width,
                       b.height,
                       a.width == b.height && a.height == b.width
                           ? "; width and height are swapped, or one picture is turned"
                           : "");
}

Result<PictureDifference> compare(const PictureView& a, const PictureView& b, const CompareOptions& options) {
    return result_of([&]() -> Result<PictureDifference> {
        const DefaultFpEnvironment environment;
        std::string wrong = pair_fault(a, b);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return Measure(a, b, options).run();
    });
}

Result<PictureDifference> compare(const Image& a, const Image& b, const CompareOptions& options) {
    return compare(PictureView(a), PictureView(b), options);
}

// ---- The picture of the difference ----

DifferenceRows::DifferenceRows(const PictureView& a, const PictureView& b, double gain) : a_(a), b_(b) {
    const auto most = static_cast<double>(std::numeric_limits<float>::max());  // infinity times 0 is NaN
    if (gain > 0) {
        factor_ = static_cast<float>(std::min(gain, most));
        return;
    }
    const std::size_t count = std::size_t{3} * b.width;
    std::vector<float> row(count), buffer(count);
    float largest = 0;
    for (std::int32_t y = 0; y < b.height; ++y) {
        subtract(y, row.data(), buffer.data());
        for (const float value : row) {
            if (is_finite(value)) largest = std::max(largest, value);
        }
    }
    if (largest > 0) factor_ = std::min(1 / largest, std::numeric_limits<float>::max());
}

void DifferenceRows::subtract(std::int32_t y, float* out, float* buffer) const {
    const std::size_t count = std::size_t{3} * b_.width;
    const float *a = a_.row(y, out), *b = b_.row(y, buffer);
    for (std::size_t i = 0; i < count; ++i) out[i] = std::fabs(a[i] - b[i]);
}

void DifferenceRows::read(std::int32_t y, float* out, float* buffer) const {
    const std::size_t count = std::size_t{3} * b_.width;
    subtract(y, out, buffer);
    for (std::size_t i = 0; i < count; ++i) out[i] = is_finite(out[i]) ? std::min(out[i] * factor_, 1.0f) : 1;
}

Result<Image> difference_image(const Image& a, const Image& b, double gain) {
    return result_of([&]() -> Result<Image> {
        const DefaultFpEnvironment environment;
        std::string wrong = pair_fault(a, b);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        Image image{b.width, b.height, std::vector<float>(b.rgb.size())};
        const DifferenceRows rows(a, b, gain);
        std::vector<float> buffer(std::size_t{3} * b.width);
        for (std::int32_t y = 0; y < b.height; ++y)
            rows.read(y, &image.rgb[buffer.size() * static_cast<std::size_t>(y)], buffer.data());
        return image;
    });
}

}  // namespace glint
