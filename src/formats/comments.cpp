// SPDX-License-Identifier: Apache-2.0
#include "formats/comments.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "base/sort_stably.h"
#include "formats/registry.h"
#include "formats/tokenizer.h"

namespace glint {
namespace {

Dialect dialect_of(std::string_view format) {
    if (format == "epfl") return {.slash_comments = true, .block_comments = true, .single_quotes = true};
    if (format == "csc473") return {.slash_comments = true, .block_comments = true};
    if (format == "nff" || format == "tachyon") return {.hash_comments = true};
    return {.hash_comments = true, .slash_comments = true};
}

// The start of a comment in this dialect, anywhere in the text, even in a string: a quick test.
bool may_have_comments(std::string_view text, Dialect dialect) {
    return (dialect.hash_comments && text.find('#') != std::string_view::npos) ||
           (dialect.slash_comments && text.find("//") != std::string_view::npos) ||
           (dialect.block_comments && text.find("/*") != std::string_view::npos);
}

bool is_blank(char c) { return static_cast<unsigned char>(c) <= 0x20 || c == 0x7f; }

std::string_view without_sign(std::string_view line, char sign) {
    while (!line.empty() && line.front() == sign) line.remove_prefix(1);
    if (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return line;
}

// The lines between /* and */.
void split_block(std::string_view text, std::vector<std::string_view>& lines) {
    const std::size_t first = lines.size();
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        line = without_sign(line, '*');
        if (!line.empty() || lines.size() > first) lines.push_back(line);
    }
    while (lines.size() > first && lines.back().empty()) lines.pop_back();
}

}  // namespace

struct SceneComments::Item {
    SourcePlace place;
    ItemKind kind = ItemKind::shape;
    std::uint32_t index = 0;
};

// One pass over a text and its items in order.
class SceneComments::Scanner {
  public:
    Scanner(SceneComments& to, std::string_view text, Dialect dialect, std::span<const Item> items)
        : to_(to), text_(text), dialect_(dialect), items_(items) {}

    void run() {
        at_ = text_.starts_with("\xef\xbb\xbf") ? 3 : 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const char second = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
            if (c == '\n') {
                end_line();
                ++at_;
            } else if (is_blank(c)) {
                ++at_;
            } else if ((c == '#' && dialect_.hash_comments) ||
                       (c == '/' && second == '/' && dialect_.slash_comments)) {
                const std::size_t end = std::min(text_.find('\n', at_), text_.size());
                const auto line = without_sign(text_.substr(at_, end - at_), c);
                take_comment({&line, 1});
                last_comment_line_ = line_;
                at_ = end;
            } else if (c == '/' && second == '*' && dialect_.block_comments) {
                take_block();
            } else {
                take_code(c);
            }
        }
        flush_heading(false);
        for (const Pending& p : pending_) {
            if (p.depth == 0) to_.tail_.push_back(p.line);
        }
    }

  private:
    struct Pending {
        std::string_view line;
        std::size_t depth;
    };

    void end_line() {
        ++line_;
        line_start_ = at_ + 1;
        has_code_ = false;
    }

    void take_block() {
        const std::size_t end = std::min(text_.find("*/", at_ + 2), text_.size());
        std::vector<std::string_view> lines;
        split_block(text_.substr(at_ + 2, end - at_ - 2), lines);
        take_comment(lines);
        for (const std::size_t stop = std::min(end + 2, text_.size()); at_ < stop; ++at_) {
            const bool had_code = has_code_;
            if (text_[at_] == '\n') end_line();
            has_code_ = had_code;
        }
        last_comment_line_ = line_;
    }

    void take_comment(std::span<const std::string_view> lines) {
        if (!seen_code_ && (heading_.empty() || line_ <= last_comment_line_ + 1) && pending_.empty()) {
            heading_.insert(heading_.end(), lines.begin(), lines.end());
            return;
        }
        if (!has_code_ && inside_item()) {
            auto& above = to_.make(current_->kind, current_->index).above;
            above.insert(above.end(), lines.begin(), lines.end());
        } else if (has_code_ && current_ != nullptr && (!closed_ || end_line_ == line_)) {
            auto& after = to_.make(current_->kind, current_->index).after;
            for (const auto line : lines) {
                if (!line.empty()) after.push_back(line);
            }
        } else {
            for (const auto line : lines) pending_.push_back({line, depth_});
        }
    }

    bool inside_item() const { return current_ != nullptr && opened_ && !closed_; }

    // The first comment belongs to the item directly below, else to the text.
    void flush_heading(bool is_item) {
        if (is_item && line_ <= last_comment_line_ + 1 && pending_.empty()) {
            for (const auto line : heading_) pending_.push_back({line, 0});
        } else {
            to_.heading_.insert(to_.heading_.end(), heading_.begin(), heading_.end());
        }
        heading_.clear();
    }

    void take_code(char c) {
        const bool is_item = reaches_item();
        if (!seen_code_) flush_heading(is_item);
        seen_code_ = has_code_ = true;
        if (is_item) begin_item();
        if (c == '"' || (c == '\'' && dialect_.single_quotes)) {
            skip_string(c);
            return;
        }
        if (c == '{' || c == '[' || c == '(') {
            ++depth_;
            opened_ = true;
        } else if ((c == '}' || c == ']' || c == ')') && depth_ > 0) {
            --depth_;
            // Comments in another block that ends here do not belong to the next item.
            std::erase_if(pending_, [&](const Pending& p) { return p.depth > (c == ')' ? depth_ : 0); });
            if (current_ != nullptr && opened_ && !closed_ && depth_ <= item_depth_) {
                closed_ = true;
                end_line_ = line_;
            }
        }
        ++at_;
    }

    bool reaches_item() const {
        if (items_.empty()) return false;
        const SourcePlace& place = items_.front().place;
        return line_ > place.line || (line_ == place.line && at_ - line_start_ + 1 >= place.column);
    }

    void begin_item() {
        current_ = &items_.front();
        items_ = items_.subspan(1);
        opened_ = closed_ = false;
        item_depth_ = depth_;
        if (pending_.empty()) return;
        auto& above = to_.make(current_->kind, current_->index).above;
        for (const Pending& p : pending_) above.push_back(p.line);
        pending_.clear();
    }

    void skip_string(char quote) {
        ++at_;
        while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') {
            const char c = text_[at_++];
            if (c == quote) return;
            if (c == '\\' && at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
        }
    }

    SceneComments& to_;
    const std::string_view text_;
    const Dialect dialect_;
    std::span<const Item> items_;  // the items after the current position
    const Item* current_ = nullptr;
    std::size_t item_depth_ = 0, depth_ = 0;
    bool opened_ = false, closed_ = false;  // the brackets of the current item
    std::size_t at_ = 0, line_start_ = 0;
    std::uint32_t line_ = 1, end_line_ = 0, last_comment_line_ = 0;
    bool has_code_ = false;   // in this line, so far
    bool seen_code_ = false;  // in this text
    std::vector<std::string_view> heading_;
    std::vector<Pending> pending_;  // for the next item
};

// A text in which comments are searched.
struct SceneComments::Source {
    std::string_view text;
    Dialect dialect;
    std::size_t file;  // index into Scene::files
};

std::vector<SceneComments::Source> SceneComments::find_sources(const Scene& scene,
                                                               std::span<const SceneText> texts) {
    std::unordered_map<std::string_view, const SceneText*> by_name;
    for (const SceneText& text : texts) by_name.try_emplace(text.name, &text);
    std::vector<Source> sources;
    for (std::size_t f = 0; f < scene.files.size(); ++f) {
        const SceneText* text = f < texts.size() && texts[f].name == scene.files[f] ? &texts[f] : nullptr;
        if (text == nullptr) {
            const auto at = by_name.find(scene.files[f]);
            if (at == by_name.end()) continue;
            text = at->second;
        }
        std::string why;
        const Format* format = find_format(*text, why);
        // The comments of a file of a mesh are about the file.
        if (format == nullptr || format->finish == finish_mesh) continue;
        const Dialect dialect = dialect_of(format->info.name);
        if (may_have_comments(text->text, dialect)) sources.push_back({text->text, dialect, f});
    }
    return sources;
}

SceneComments::SceneComments(const Scene& scene, std::span<const SceneText> texts) {
    const std::vector<Source> sources = find_sources(scene, texts);
    if (sources.empty()) return;
    std::vector<Item> items;
    const auto add = [&](SourcePlace place, ItemKind kind, std::size_t index) {
        if (place.line != 0) items.push_back({place, kind, static_cast<std::uint32_t>(index)});
    };
    const auto add_all = [&](const ItemTexts& list, ItemKind kind) {
        for (std::size_t i = 0; i < list.places.size(); ++i) add(list.places[i], kind, i);
    };
    // If several items have the same place, the first one counts.
    add_all(scene.shape_texts, ItemKind::shape);
    add_all(scene.light_texts, ItemKind::light);
    add(scene.camera_place, ItemKind::camera, 0);
    add(scene.background_place, ItemKind::background, 0);
    add(scene.fog_place, ItemKind::fog, 0);
    add(scene.gradient_place, ItemKind::gradient, 0);
    add(scene.occlusion_place, ItemKind::occlusion, 0);
    add_all(scene.material_texts, ItemKind::material);
    add_all(scene.texture_texts, ItemKind::texture);
    const auto order = [](const Item& i) { return std::tuple(i.place.file, i.place.line, i.place.column); };
    sort_stably(items, [&](const Item& a, const Item& b) { return order(a) < order(b); });
    items.erase(std::unique(items.begin(), items.end(),
                            [](const Item& a, const Item& b) { return a.place == b.place; }),
                items.end());
    auto next = items.begin();
    for (const Source& source : sources) {
        while (next != items.end() && next->place.file < source.file) ++next;
        const auto first = next;
        while (next != items.end() && next->place.file == source.file) ++next;
        const std::span own(items.data() + (first - items.begin()), static_cast<std::size_t>(next - first));
        Scanner(*this, source.text, source.dialect, own).run();
    }
}

const ItemComments* SceneComments::of(ItemKind kind, std::uint32_t index) const {
    const auto at = items_.find(std::uint64_t{static_cast<std::uint8_t>(kind)} << 32 | index);
    return at == items_.end() ? nullptr : &at->second;
}

void SceneComments::end_block(BlockWriter& block, ItemKind kind, std::uint32_t index) const {
    if (const ItemComments* c = of(kind, index)) {
        block.end(c->above, c->after);
    } else {
        block.end();
    }
}

ItemComments& SceneComments::make(ItemKind kind, std::uint32_t index) {
    return items_[std::uint64_t{static_cast<std::uint8_t>(kind)} << 32 | index];
}

}  // namespace glint
