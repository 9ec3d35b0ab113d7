// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/status.h"
#include "compare/float_difference.h"
#include "compare/left_structure.h"
#include "compare/lines.h"
#include "compare/picture_causes.h"
#include "compare/step_agreement.h"
#include "image/levels.h"
#include "image/quantize.h"

namespace glint {
namespace {

// The scene's own picture stands for a picture from which it differs by less than this part of the difference
// to be explained.
constexpr double k_same_part = 0.1;
// Of a large picture causes are tried on a sample of rows, and the first of them once more on all. Where the
// sample has not about as much of the difference as the whole, by this factor, it is of rows that differ.
constexpr std::size_t k_confirmed = 5;
constexpr double k_fair_sample = 2;
// Quantisation and dithering change a byte by at most this.
constexpr int k_faint = 4;
// Fewer pixels than this fraction are few: those of ties on edges, for example.
constexpr double k_few = 0.001;
// A shift is looked for if a cause that leaves no structure leaves more than this fraction at edges.
constexpr double k_edges_left = 0.01;
// A second cause explains at least this fraction more.
constexpr double k_second_explains = 0.003;
// Smaller pictures are done before another thread has begun.
constexpr std::int64_t k_min_for_threads = 1 << 18;
// In 255ths: so near to a tie of rounding, another program's number may be on its other side.
constexpr double k_tie_width = 0.002;

// Whether it changes shadow rays. Those of correct programs begin in different places, which moves the
// borders of shadows by as much.
bool moves_shadows(const Cause& cause) {
    return cause.name.starts_with("shadow-") || cause.name.starts_with("epsilon-");
}

// Whether a number that differs by no more than that becomes this byte.
bool may_become(float value, const ByteRule& rule, std::uint8_t byte) {
    for (const double by : {-k_tie_width, k_tie_width}) {
        const auto moved = static_cast<float>(static_cast<double>(value) + by / 255);
        std::uint8_t made = 0;
        quantize_row(&moved, 1, 8, rule, &made);
        if (made == byte) return true;
    }
    return false;
}

}  // namespace

CauseFinder::CauseFinder(const PictureView& reference, BytePicture bytes, const Scene* scene,
                         const CauseOptions& options)
    : bytes_(std::move(bytes)),
      reference_(reference),
      edges_(edges_of(bytes_, options.threads)),
      scene_(scene),
      options_(options) {}

CauseFinder::CauseFinder(BytePicture bytes, const Scene* scene, const CauseOptions& options)
    : bytes_(std::move(bytes)),
      reference_(view_of(bytes_)),
      edges_(edges_of(bytes_, options.threads)),
      scene_(scene),
      options_(options) {}

Search CauseFinder::start(BytePicture bytes) const {
    const PictureView view = view_of(bytes);  // of the elements, which stay where they are
    return start(view, std::move(bytes));
}

Search CauseFinder::start(const PictureView& picture, BytePicture bytes) const {
    Search search;
    search.faulty = std::move(bytes);
    measure(search);
    search.report.difference = search.whole.all;
    if (options_.as_floats && is_beyond_bytes(picture, reference_, search.whole.all == 0, search.report)) {
        search.whole = {};
        return search;
    }
    take_sample(search);
    count_differing(search);
    look_at(search);
    // Truncation changes half of the bytes.
    if (search.report.agrees && search.differing > 0 && is_few(search.differing)) judge_agreement(search);
    return search;
}

// The difference to be explained; that of the outermost pixels only if there is no other.
void CauseFinder::measure(Search& search) const {
    const bool is_small = std::int64_t{reference_.width} * reference_.height < k_min_for_threads;
    search.area = {&edges_, all_rows(reference_.height), 1, is_small ? 1 : options_.threads};
    if (std::min(reference_.width, reference_.height) < 3) search.area.rim = 0;
    search.whole = distance(search.faulty, bytes_, search.area);
    if (search.whole.all == 0) {
        search.area.rim = 0;
        search.whole = distance(search.faulty, bytes_, search.area);
    }
    search.sample = search.area;
}

// The rows on which causes are tried first, and the structure of the difference.
void CauseFinder::take_sample(Search& search) const {
    search.sample.rows = sample_of(search.area.rows, reference_.width);
    const double sampled = distance(search.faulty, bytes_, search.sample).all;
    if (sampled > k_fair_sample * search.whole.all || sampled * k_fair_sample < search.whole.all) {
        Rows differing = search.area.rows;
        std::erase_if(differing, [&](std::int32_t y) { return equal_rows(search.faulty, bytes_, {y}); });
        search.sample.rows = sample_of(differing, reference_.width);
    }
    search.structure = structured_pixels(bytes_, search.faulty, search.area);
}

void CauseFinder::find(std::vector<Search>& searches) {
    for (Search& search : searches) search.target = &search.faulty;
    const auto open =
        std::count_if(searches.begin(), searches.end(), [](const Search& s) { return s.is_open(); });
    if (open == 0) return;
    if (scene_ != nullptr) render_scene(searches);
    steps_ = static_cast<std::size_t>(open) * picture_causes().size() + (trials_ ? trials_->steps() : 0);
    made_ = bytes_;
    for (Search& search : searches) {
        if (search.is_open() && search.has_content) try_pictures(search);
    }
    if (trials_) trials_->run(searches, [&] { step(); });
    for (Search& search : searches) {
        if (is_cancelled() && search.is_open()) search.status = cancelled();
        if (search.is_open()) name(search);
    }
}

void CauseFinder::count_differing(Search& search) const {
    for (std::size_t i = 0; i < bytes_.rgb.size(); i += 3) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            most = std::max(most, std::abs(int{bytes_.rgb[c]} - int{search.faulty.rgb[c]}));
        search.differing += most > 0;
        search.beyond_rounding += most > k_rounding;
        search.beyond_faint += most > k_faint;
        if (most > k_rounding && edges_[i / 3] == 0) search.is_on_edges = false;
    }
    search.report.agrees = search.beyond_rounding == 0 && !options_.as_floats;
}

bool CauseFinder::is_few(std::size_t pixels) const {
    return static_cast<double>(pixels) <= k_few * static_cast<double>(bytes_.rgb.size() / 3);
}

// What can be said without any cause.
void CauseFinder::look_at(Search& search) const {
    const auto agreement = step_agreement(search.faulty, bytes_, search.sample.rows);
    search.same_view = !agreement || agreement->one_way >= k_same_view;
    const std::optional<std::string> color = one_color(search.faulty), of_b = one_color(bytes_);
    search.has_content = color.has_value() == of_b.has_value();
    search.is_one_color = color.has_value();
    if (search.has_content) return;
    search.report.remark =
        color ? fmt::format("The picture is one color throughout, {}: nothing is visible.", *color)
              : fmt::format("The reference is one color throughout, {}: nothing is visible.", *of_b);
}

void CauseFinder::step() {
    ++done_;
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(steps_));
}

void CauseFinder::render_scene(std::vector<Search>& searches) {
    trials_ = std::make_unique<SceneTrials>(*scene_, bytes_, edges_, options_);
    const auto& rendered = trials_->rendered();
    for (Search& search : searches) {
        if (!search.is_open()) continue;
        if (!rendered) {
            search.status = is_cancelled() ? cancelled()
                                           : failure(ErrorCode::invalid_scene,
                                                     "the scene cannot be rendered at the pictures' size");
            continue;
        }
        CauseReport& report = search.report;
        const double near = k_same_part * report.difference;
        const double from_a = distance(rendered->bytes, search.faulty, search.area).all,
                     from_b = distance(rendered->bytes, bytes_, search.area).all;
        report.scene_from_a = from_a;
        report.scene_from_b = from_b;
        report.swapped = from_a < near && from_b > near;
        if (report.swapped) search.target = &bytes_;
        if (report.swapped || from_b < near) search.original = &rendered->bytes;
    }
    if (rendered && !options_.as_floats) take_out_rounding(searches, *rendered);
}

// The reference may be of a program that rounds differently. If the scene's own picture is the reference
// within rounding, its bytes stand for the reference's: also in the pictures to be explained, where these
// have the reference's. Else every cause would seem to leave the differences of rounding.
void CauseFinder::take_out_rounding(std::vector<Search>& searches, const RenderedScene& scene) {
    const std::vector<std::uint8_t>& rendered = scene.bytes.rgb;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        if (std::abs(int{bytes_.rgb[i]} - int{rendered[i]}) > k_rounding) return;
    }
    is_of_scene_ = true;
    const auto is_open = [](const Search& search) { return search.is_open() && !search.report.agrees; };
    // Pictures that agree with the reference have nothing to be explained.
    for (Search& search : searches) {
        if (!is_open(search)) continue;
        for (std::size_t i = 0; i < rendered.size(); ++i) {
            if (search.faulty.rgb[i] == bytes_.rgb[i]) search.faulty.rgb[i] = rendered[i];
        }
    }
    std::copy(rendered.begin(), rendered.end(), bytes_.rgb.begin());
    for (Search& search : searches) {
        if (!is_open(search)) continue;
        take_out_tie(search, scene);
        measure(search);
        take_sample(search);
    }
}

// If the background's color is a tie of rounding, all of it differs in a program that rounds differently,
// which may be more than what a mistake changes.
void CauseFinder::take_out_tie(Search& search, const RenderedScene& scene) const {
    const std::vector<bool>& background = trials_->background();
    const auto found = std::find(background.begin(), background.end(), true);
    if (scene_->gradient || found == background.end()) return;
    const std::size_t first = 3 * static_cast<std::size_t>(found - background.begin());
    const std::uint8_t* const color = &scene.bytes.rgb[first];
    const ByteRule rule = trials_->rule();
    const auto is_other_side = [&](const std::uint8_t* pixel) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (pixel[c] != color[c] && !may_become(scene.image.rgb[first + c], rule, pixel[c])) return false;
        }
        return true;
    };
    for (std::size_t i = 0; i < search.faulty.rgb.size(); i += 3) {
        std::uint8_t* const pixel = &search.faulty.rgb[i];
        if (!std::equal(pixel, pixel + 3, color) && is_other_side(pixel)) std::copy_n(color, 3, pixel);
    }
}

// What the causes that are seen in pictures are made from: the scene's floats know what bytes have lost,
// if it draws this very picture.
PictureSource CauseFinder::source(const Search& search, const Rows& rows) const {
    const CauseReport& report = search.report;
    const bool by_scene =
        trials_ && trials_->rendered() &&
        (report.swapped || is_of_scene_ || *report.scene_from_b < k_same_part * report.difference);
    return {by_scene ? PictureView(trials_->rendered()->image) : reference_,
            by_scene ? trials_->rendered()->bytes : bytes_,
            *search.target,
            search.sample,
            rows,
            by_scene,
            by_scene ? &trials_->background() : nullptr};
}

void CauseFinder::try_pictures(Search& search) {
    const PictureSource from = source(search, search.sample.rows);
    const bool is_sample = search.sample.rows.size() < search.area.rows.size();
    const Distance of_sample = distance(from.bytes, *search.target, search.sample);
    const auto estimate = [](double left, double sampled, double whole) {
        return sampled > 0 ? left / sampled * whole : whole;
    };
    for (std::size_t i = 0; i < picture_causes().size() && !is_cancelled(); ++i, step()) {
        const PictureCause& cause = picture_causes()[i];
        if (cause.is_rendered && from.unclamped) continue;
        const std::optional<std::string> detail = cause.make(from, made_);
        if (!detail || equal_rows(made_, from.bytes, from.rows)) continue;
        CauseCandidate candidate{
            {cause.name, fmt::format(fmt::runtime(cause.explanation), *detail), 0, 0, false},
            cause.least,
            cause.freedom,
            distance(made_, *search.target, search.sample)};
        candidate.is_turn = cause.is_turn;
        candidate.parameters = cause.parameters;
        candidate.of_pictures = i;
        if (is_sample) {
            Distance& left = candidate.left;
            left = {estimate(left.all, of_sample.all, search.whole.all),
                    estimate(left.calm, of_sample.calm, search.whole.calm)};
            candidate.is_estimated = true;
        }
        search.add(made_, std::move(candidate));
    }
}

// Looks at the first ones on all rows, and drops what is only estimated.
void CauseFinder::confirm(Search& search) {
    bool away_from_edges = false;
    std::vector<CauseCandidate> first = ranked(search, away_from_edges);
    first.resize(std::min(first.size(), k_confirmed));
    const PictureSource from = source(search, search.area.rows);
    for (CauseCandidate& candidate : search.found) {
        const auto is_it = [&](const CauseCandidate& c) { return c.of_pictures == candidate.of_pictures; };
        if (!candidate.of_pictures || std::none_of(first.begin(), first.end(), is_it)) continue;
        picture_causes()[*candidate.of_pictures].make(from, made_);
        search.confirm(made_, view_of(made_), {}, candidate, candidate.is_near());
    }
    std::erase_if(search.found, [](const CauseCandidate& c) { return c.is_estimated; });
    for (CauseCandidate& c : search.found) c.is_confirmed = true;
}

std::optional<CausePair> CauseFinder::find_pair(Search& search) {
    double least = search.whole.all;
    bool is_explained = false;
    for (const CauseCandidate& c : search.found) {
        if (c.freedom == 0) least = std::min(least, c.left.all);
        is_explained = is_explained || (c.is_exact && c.freedom == 0);
    }
    if (!is_explained) return trials_->find_pair(search, PairKind::any);
    // Edges may be those of another renderer.
    if (least <= k_edges_left * search.whole.all) return std::nullopt;
    return trials_->find_pair(search, PairKind::with_shift);
}

void CauseFinder::name(Search& search) {
    confirm(search);
    std::optional<CausePair> pair;
    if (trials_ && trials_->rendered() && !is_few(search.beyond_faint)) pair = find_pair(search);
    name_causes(search);
    CauseReport& report = search.report;
    if (pair) name_pair(search, *pair);
    if (trials_ && (report.causes.empty() || report.causes.front().perhaps))
        report.where = trials_->where_text(search);
    judge_agreement(search);
}

// Pictures that differ by no more than rounding have no cause but truncation. A few pixels on edges have none
// that is only likely, or of shadows, and a few elsewhere have none that is a guess from the pictures alone.
void CauseFinder::judge_agreement(Search& search) const {
    CauseReport& report = search.report;
    const bool is_explained = !report.causes.empty() && !report.causes.front().perhaps;
    const std::size_t pixels = bytes_.rgb.size() / 3;
    if (report.agrees) {
        if (is_explained && report.causes.front().name == k_rounded_down) return;
        report.remark =
            fmt::format("The pictures agree: all pixels are within rounding; {} of {} {} by 1 of 255.",
                        search.differing, pixels, search.differing == 1 ? "differs" : "differ");
    } else if (is_few(search.beyond_rounding) && report.remark.empty() &&
               (!is_explained || (search.is_on_edges && moves_shadows(report.causes.front())))) {
        report.remark =
            fmt::format("All pixels but {} of {} are within rounding (1 of 255){}.", search.beyond_rounding,
                        pixels, search.is_on_edges ? ", and these are on edges, where renderers differ" : "");
        std::erase_if(report.causes, [](const Cause& cause) { return cause.perhaps && !cause.rendered; });
        if (!search.is_on_edges && !report.causes.empty()) return;
    } else {
        return;
    }
    report.causes.clear();
    report.then.clear();
    report.where.clear();
    report.nearest.reset();
    report.away_from_edges = false;
    search.pair.clear();
    search.whole = {};  // there is nothing to explain
}

void CauseFinder::name_pair(Search& search, CausePair& pair) const {
    CauseReport& report = search.report;
    const double least_gain = k_second_explains * search.whole.all;
    // The first one may be all, once its numbers are fitted better.
    const auto is_all = [&] { return pair.first.left.all - pair.second.left.all <= least_gain; };
    // Of causes that leave nearly the same alone, the one that was ranked first is named, if the pair with it
    // explains the picture, too.
    const CauseCandidate* ranked_first =
        report.causes.empty() ? nullptr : search.found_as(report.causes.front());
    if (ranked_first != nullptr && std::fabs(ranked_first->left.all - pair.first.left.all) <= least_gain) {
        if (is_all()) {
            pair.first = *ranked_first;
        } else if (auto other = trials_->with_first(search, *ranked_first, pair);
                   other && other->second.is_exact >= pair.second.is_exact &&
                   other->second.left.all <= pair.second.left.all + least_gain) {
            pair = *std::move(other);
        }
    }
    CauseCandidate &first = pair.first, &second = pair.second;
    for (CauseCandidate* c : {&first, &second}) {
        c->cause.remaining = c->left.all;
        c->cause.explained = std::max(1 - c->left.all / search.whole.all, 0.0);
        c->cause.perhaps = is_all() ? !first.is_exact : !second.is_exact;
    }
    std::erase_if(report.causes, [&](const Cause& c) { return c.name == first.cause.name; });
    report.causes.insert(report.causes.begin(), first.cause);
    search.pair = {first};
    if (!is_all()) {
        report.then = {second.cause};
        search.pair.push_back(second);
    }
    report.remark.clear();
    report.nearest.reset();
}

}  // namespace glint
