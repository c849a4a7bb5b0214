// Walks through the text of a mesh file, word by word, and knows the line and column.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace lancer {

class TextCursor {
public:
    // With `continued`, a backslash at the end of a line joins the next one to it. With `comment` not 0, the rest of a line after it is skipped.
    TextCursor(std::string_view text, bool continued, char comment)
        : at_(text.data()), end_(at_ + text.size()), line_begin_(at_), continued_(continued), comment_(comment) {}

    int line() const { return line_; }
    int column() const { return static_cast<int>(at_ - line_begin_) + 1; }  // in bytes, from 1
    bool at_end() const { return at_ == end_; }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

    // Moves to the next word of this line; false when the line has no more.
    bool find_word() {
        while (at_ != end_) {
            if (is_blank(*at_)) {
                ++at_;
            } else if (continued_ && *at_ == '\\' && skip_joined_line()) {
                continue;
            } else {
                return !ends_line(*at_);
            }
        }
        return false;
    }

    // Moves to the next word, over as many lines as it takes.
    bool find_word_on_any_line() {
        while (!find_word()) {
            if (at_end()) {
                return false;
            }
            next_line();
        }
        return true;
    }

    void next_line() {
        while (find_word()) {
            skip(word().size());
        }
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r') {  // a comment
            ++at_;
        }
        if (at_ != end_) {
            at_ += *at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n' ? 2 : 1;
            begin_line();
        }
    }

    // The word here, without moving.
    std::string_view word() const {
        const char* stop = at_;
        while (stop != end_ && !is_blank(*stop) && !ends_line(*stop) && !(continued_ && *stop == '\\' && joins(stop))) {
            ++stop;
        }
        return {at_, static_cast<std::size_t>(stop - at_)};
    }

    // All words from here to the end of the line, with what is between them; moves behind them.
    std::string rest_of_line() {
        const char* first = at_;
        const char* last = at_;
        while (find_word() && first <= at_) {
            skip(word().size());
            last = at_;
        }
        return {first, last};
    }

    void skip(std::size_t bytes) { at_ += bytes; }

    // The word here as a number; moves behind it. Too small becomes 0. False, without moving, when it is no number or not finite in `float`.
    bool read_number(float& number) {
        const std::string_view text = word();
        const char* first = text.data();
        const char* last = first + text.size();
        double value = 0.0;
        const char* begin = first != last && *first == '+' ? first + 1 : first;
        const auto [stop, problem] = std::from_chars(begin, last, value);
        if (stop != last || problem == std::errc::invalid_argument) {
            return false;
        }
        if (problem == std::errc::result_out_of_range) {
            const std::size_t exponent = text.find_first_of("eE");
            const bool small = exponent != std::string_view::npos && exponent + 1 < text.size() && text[exponent + 1] == '-';
            value = small || exponent == std::string_view::npos ? 0.0 : HUGE_VAL;
        }
        number = static_cast<float>(value);
        if (!std::isfinite(number)) {
            return false;
        }
        at_ = last;
        return true;
    }

    // A whole number at the start of the word here; moves behind it. False, without moving, when there is none.
    bool read_integer(std::int64_t& number) {
        const char* begin = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        const auto [stop, problem] = std::from_chars(begin, end_, number);
        if (problem != std::errc{}) {
            return false;
        }
        at_ = stop;
        return true;
    }

    bool stands(char c) const { return at_ != end_ && *at_ == c; }

    // Moves behind `c` when it stands here.
    bool take(char c) {
        const bool here = stands(c);
        at_ += here ? 1 : 0;
        return here;
    }

    bool at_word_end() const { return at_ == end_ || is_blank(*at_) || ends_line(*at_) || (continued_ && *at_ == '\\' && joins(at_)); }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    bool ends_line(char c) const { return c == '\n' || c == '\r' || (comment_ != 0 && c == comment_); }

    bool joins(const char* backslash) const {
        const char* next = backslash + 1;
        return next != end_ && (*next == '\n' || (*next == '\r' && end_ - next > 1 && next[1] == '\n'));
    }

    bool skip_joined_line() {
        if (!joins(at_)) {
            return false;
        }
        at_ += at_[1] == '\r' ? 3 : 2;
        begin_line();
        return true;
    }

    void begin_line() {
        ++line_;
        line_begin_ = at_;
    }

    const char* at_;
    const char* end_;
    const char* line_begin_;
    int line_ = 1;
    bool continued_;
    char comment_;
};

}  // namespace lancer
