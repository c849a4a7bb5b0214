// Cuts a text into words: quoted strings, brackets, and what stands between blanks. `#` begins a comment that ends with its line.
#pragma once

#include <string>
#include <string_view>

namespace lancer::pbrt {

inline bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

class Words {
public:
    explicit Words(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

    // The next word, with its quotes where it has some; empty at the end of the text. A quote that does not end is a word that ends without one.
    std::string_view next() {
        skip_blanks();
        const char* const begin = at_;
        if (at_ == end_) {
            return {begin, 0};
        }
        if (*at_ == '"') {
            ++at_;
            while (at_ != end_ && *at_ != '"' && *at_ != '\n') {
                at_ += *at_ == '\\' && end_ - at_ > 1 ? 2 : 1;
            }
            at_ += at_ != end_ && *at_ == '"' ? 1 : 0;
        } else if (*at_ == '[' || *at_ == ']') {
            ++at_;
        } else {
            while (at_ != end_ && !is_blank(*at_) && *at_ != '"' && *at_ != '[' && *at_ != ']' && *at_ != '#') {
                ++at_;
            }
        }
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    std::string_view peek() {
        const char* const here = at_;
        const std::string_view word = next();
        at_ = word.empty() ? at_ : here;
        return word;
    }

    // All up to the bracket that closes, which is read, too; `closed` is false when there is none.
    std::string_view up_to_bracket(bool& closed) {
        skip_blanks();
        const char* const begin = at_;
        for (std::string_view word = quick_next(); !word.empty(); word = quick_next()) {
            if (word == "]") {
                closed = true;
                return {begin, static_cast<std::size_t>(word.data() - begin)};
            }
        }
        closed = false;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    const char* here() const { return at_; }

private:
    void skip_blanks() {
        while (at_ != end_) {
            if (is_blank(*at_)) {
                ++at_;
            } else if (*at_ == '#') {
                skip_comment();
            } else {
                return;
            }
        }
    }

    void skip_comment() {
        while (at_ != end_ && *at_ != '\n') {
            ++at_;
        }
    }

    // The next quoted string or bracket: numbers between them need not be looked at one by one.
    std::string_view quick_next() {
        while (at_ != end_ && *at_ != ']' && *at_ != '"' && *at_ != '[') {
            if (*at_ == '#') {
                skip_comment();
            } else {
                ++at_;
            }
        }
        return next();
    }

    const char* at_;
    const char* end_;
};

inline bool is_quoted(std::string_view word) { return word.size() >= 2 && word.front() == '"' && word.back() == '"'; }
inline std::string_view without_quotes(std::string_view word) { return is_quoted(word) ? word.substr(1, word.size() - 2) : word; }

// What a quoted string says: its escapes \" \\ \n \t \r \b \f \' done. Others stay as they are: Windows writes paths with backslashes.
std::string unescaped(std::string_view word);

}  // namespace lancer::pbrt
