#include "lancer/import/toml/nesting.h"

#include <fmt/format.h>

namespace lancer::notation {

namespace {

constexpr int deepest_value = 32;
constexpr int longest_name = 32;  // parts between dots

class Scanner {
public:
    Scanner(std::string_view text, const std::string& file, Diagnostics& diagnostics)
        : text_(text), file_(file), diagnostics_(diagnostics) {}

    Nesting run() {
        while (at_ < text_.size() && !result_.too_deep) {
            step();
        }
        end_line();
        return std::move(result_);
    }

private:
    bool follows(std::string_view word) const { return text_.substr(at_).starts_with(word); }

    void step() {
        switch (text_[at_]) {
            case '\n':
                ++at_, parts_ = 1, end_line();
                return;
            case '#':
                skip_comment();
                return;
            case '"':
            case '\'':
                skip_string();
                return;
            case '[':
            case '{':
                parts_ = 1;
                if (++depth_ > deepest_value) {
                    refuse(fmt::format("values are nested too deep: at most {} lists or tables inside each other", deepest_value));
                }
                break;
            case ']':
            case '}':
                parts_ = 1;
                depth_ = depth_ > 0 ? depth_ - 1 : 0;
                break;
            case '=':
            case ',':
                parts_ = 1;
                break;
            case '.':
                if (++parts_ > longest_name) {
                    refuse(fmt::format("this name has too many parts: at most {} between dots", longest_name));
                }
                break;
            default:
                break;
        }
        ++at_;
    }

    void skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n') {
            ++at_;
        }
    }

    // Strings between one or three quotes; a backslash escapes in the double-quoted ones only.
    void skip_string() {
        const char quote = text_[at_];
        const std::string three(3, quote);
        const bool several_lines = follows(three);
        at_ += several_lines ? 3 : 1;
        while (at_ < text_.size()) {
            if (several_lines && follows(three)) {
                at_ += 3;
                while (at_ < text_.size() && text_[at_] == quote) {
                    ++at_;  // up to two quotes may stand before the closing three
                }
                return;
            }
            const char c = text_[at_];
            if (!several_lines && (c == quote || c == '\n')) {
                at_ += c == quote ? 1 : 0;
                return;
            }
            if (c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') {
                ++at_;
            }
            ++at_;
            if (c == '\n') {
                in_string_ = true;
                end_line();
            }
        }
    }

    void end_line() {
        const bool inside = depth_ > 0 || in_string_;
        result_.stands_alone.push_back(!inside && !began_inside_);
        began_inside_ = inside;
        in_string_ = false;
        line_begin_ = at_;
    }

    void refuse(const std::string& message) {
        int column = 1;  // in characters, not bytes
        for (std::size_t i = line_begin_; i < at_; ++i) {
            column += (static_cast<unsigned char>(text_[i]) & 0xc0u) != 0x80u ? 1 : 0;
        }
        diagnostics_.error({file_, static_cast<int>(result_.stands_alone.size()) + 1, column}, message);
        result_.too_deep = true;
    }

    std::string_view text_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    std::size_t line_begin_ = 0;
    int depth_ = 0;
    int parts_ = 1;
    bool in_string_ = false;  // the line that ends does so within a string
    bool began_inside_ = false;
    Nesting result_;
};

}  // namespace

Nesting measure_nesting(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    return Scanner(text, file, diagnostics).run();
}

}  // namespace lancer::notation
