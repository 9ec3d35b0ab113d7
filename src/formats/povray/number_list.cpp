// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/number_list.h"

#include "formats/number_text.h"

namespace glint::povray {
namespace {

bool is_list_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

const char* after_blanks(const char* at, const char* end) {
    while (at != end && is_list_blank(*at)) ++at;
    return at;
}

const char* after_digits(const char* at, const char* end) {
    while (at != end && is_decimal_digit(*at)) ++at;
    return at;
}

// [sign] digits [. digits] [e [sign] digits], and blanks. Null if it is something else.
const char* after_number(const char* at, const char* end) {
    if (at != end && (*at == '-' || *at == '+')) at = after_blanks(at + 1, end);
    const char* const from = at;
    at = after_digits(at, end);
    std::ptrdiff_t digits = at - from;
    if (at != end && *at == '.') {
        const char* const decimals = at + 1;
        at = after_digits(decimals, end);
        digits += at - decimals;
    }
    if (digits == 0) return nullptr;
    if (at != end && (*at == 'e' || *at == 'E')) {
        ++at;
        if (at != end && (*at == '-' || *at == '+')) ++at;
        const char* const power = at;
        at = after_digits(at, end);
        if (at == power) return nullptr;
    }
    return after_blanks(at, end);
}

// < number, number [, number] >, and blanks.
const char* after_vector(const char* at, const char* end) {
    for (int terms = 1;; ++terms) {
        at = after_number(after_blanks(at + 1, end), end);  // after `<` or `,`
        if (at == nullptr || at == end) return nullptr;
        if (*at == '>' && terms > 1) return after_blanks(at + 1, end);
        if (*at != ',' || terms == 3) return nullptr;
    }
}

}  // namespace

const char* end_of_number_list(const char* from, const char* end) {
    const char* at = after_blanks(from, end);
    while (at != end && *at != '}') {
        const bool is_vector = *at == '<';
        at = is_vector ? after_vector(at, end) : after_number(at, end);
        if (at == nullptr || at == end) return nullptr;
        if (*at == ',') {
            at = after_blanks(at + 1, end);
        } else if (*at != '<' && *at != '}') {
            return nullptr;  // an operator, or a number without a comma before it
        }
    }
    return at == end ? nullptr : at;
}

void NumberList::skip_blanks() { at_ = after_blanks(at_, end_); }

double NumberList::read() {
    const char sign = *at_;
    if (sign == '-' || sign == '+') at_ = after_blanks(at_ + 1, end_);
    double value = 0;
    const auto goes_on = [](char c) { return c == 'e' || c == 'E'; };
    const char* const quick = read_short_number(at_, end_, value, goes_on);
    at_ = quick != nullptr ? quick : read_any_number(at_, end_, value);
    if (!(value <= 1e300)) value = 1e300;
    skip_blanks();
    return sign == '-' ? -value : value;
}

void NumberList::end_item() {
    if (at_ != end_ && *at_ == ',') ++at_;
    skip_blanks();
}

double NumberList::number() {
    const double value = read();
    end_item();
    return value;
}

Vec3 NumberList::vector(bool& is_short) {
    double v[3] = {};
    int terms = 0;
    do {
        ++at_;  // `<` or `,`
        skip_blanks();
        v[terms++] = read();
    } while (*at_ == ',' && terms < 3);
    ++at_;
    skip_blanks();
    end_item();
    is_short = terms < 3;
    return {v[0], v[1], v[2]};
}

}  // namespace glint::povray
