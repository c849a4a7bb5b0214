#include <charconv>
#include <cmath>

#include "lancer/import/gltf/json.h"

namespace lancer::gltf {

namespace {

constexpr std::size_t deepest = 100;
constexpr std::size_t most_values = std::size_t{8} << 20;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | code >> 6);
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

}  // namespace

// No recursion: the arrays and objects that are open lie on a list.
class JsonParser {
public:
    JsonParser(JsonTree& tree, std::string_view text, JsonProblem& problem) : tree_(tree), text_(text), problem_(problem) {}

    bool parse() {
        do {
            if (!value()) {
                return false;
            }
            if (!close_what_ends()) {
                return false;
            }
        } while (!open_.empty());
        skip_space();
        return at_ == text_.size() || fail("expected the end of the file after the JSON value");
    }

private:
    bool fail(std::string message) {
        problem_ = {at_, std::move(message)};
        return false;
    }

    bool ended() const { return at_ >= text_.size(); }
    char now() const { return ended() ? '\0' : text_[at_]; }

    void skip_space() {
        while (!ended() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t')) {
            ++at_;
        }
    }

    // After a value: commas lead to the next one, brackets end what is open.
    bool close_what_ends() {
        while (!open_.empty()) {
            JsonValue& around = tree_.values_[open_.back()];
            const bool is_array = around.kind == JsonKind::array;
            skip_space();
            if (now() == ',' && around.count > 0) {
                ++at_;
                return true;
            }
            if (now() != (is_array ? ']' : '}')) {
                // An array or object that has just been opened goes on with its first value.
                return around.count == 0 || fail(is_array ? "expected \",\" or \"]\"" : "expected \",\" or \"}\"");
            }
            ++at_;
            around.after = static_cast<std::uint32_t>(tree_.values_.size());
            open_.pop_back();
        }
        return true;
    }

    bool value() {
        std::string_view key;
        skip_space();
        if (!open_.empty()) {
            JsonValue& around = tree_.values_[open_.back()];
            ++around.count;
            if (around.kind == JsonKind::object) {
                if (now() != '"') {
                    return fail("expected a name in double quotes");
                }
                if (!string(key)) {
                    return false;
                }
                skip_space();
                if (now() != ':') {
                    return fail("expected \":\" after the name");
                }
                ++at_;
                skip_space();
            }
        }
        if (tree_.values_.size() >= most_values) {
            return fail("the file has more than 8 million JSON values");
        }
        JsonValue value;
        value.key = key;
        value.byte = at_;
        const std::size_t index = tree_.values_.size();
        value.after = static_cast<std::uint32_t>(index + 1);
        const char c = now();
        if (c == '{' || c == '[') {
            if (open_.size() >= deepest) {
                return fail("the JSON is nested more than 100 deep");
            }
            ++at_;
            value.kind = c == '{' ? JsonKind::object : JsonKind::array;
            open_.push_back(static_cast<std::uint32_t>(index));
        } else if (c == '"') {
            value.kind = JsonKind::string;
            if (!string(value.text)) {
                return false;
            }
        } else if (c == '-' || is_digit(c)) {
            value.kind = JsonKind::number;
            if (!number(value.number)) {
                return false;
            }
        } else if (take("true") || take("false")) {
            value.kind = JsonKind::boolean;
            value.number = c == 't' ? 1.0 : 0.0;
        } else if (!take("null")) {
            return fail(ended() ? "the file ends within the JSON" : "expected a JSON value");
        }
        tree_.values_.push_back(value);
        return true;
    }

    bool take(std::string_view word) {
        if (text_.substr(at_, word.size()) != word) {
            return false;
        }
        at_ += word.size();
        return true;
    }

    bool number(double& result) {
        const std::size_t begin = at_;
        const auto digits = [&] {
            const std::size_t first = at_;
            while (is_digit(now())) {
                ++at_;
            }
            return at_ > first;
        };
        if (now() == '-') {
            ++at_;
        }
        const bool leading_zero = now() == '0';
        const std::size_t whole = at_;
        if (!digits() || (leading_zero && at_ - whole > 1)) {
            return fail("expected a number, without zeros in front");
        }
        if (now() == '.') {
            ++at_;
            if (!digits()) {
                return fail("expected digits after the decimal point");
            }
        }
        if (now() == 'e' || now() == 'E') {
            ++at_;
            if (now() == '+' || now() == '-') {
                ++at_;
            }
            if (!digits()) {
                return fail("expected digits in the exponent");
            }
        }
        const auto parsed = std::from_chars(text_.data() + begin, text_.data() + at_, result);
        if (parsed.ec == std::errc::result_out_of_range) {
            // Too near to zero is zero; what is too far away no renderer can use.
            double mantissa = 0.0;
            std::string_view written = text_.substr(begin, at_ - begin);
            const std::size_t e = written.find_first_of("eE");
            const bool small = e != std::string_view::npos ? written[e + 1] == '-' : written.find('.') != std::string_view::npos;
            if (!small) {
                return fail("the number is too large");
            }
            result = mantissa;
        }
        return true;
    }

    // Those without escapes are views of the text.
    bool string(std::string_view& result) {
        const std::size_t begin = ++at_;
        while (!ended() && text_[at_] != '"' && text_[at_] != '\\' && static_cast<unsigned char>(text_[at_]) >= 0x20) {
            ++at_;
        }
        if (now() == '"') {
            result = text_.substr(begin, at_ - begin);
            ++at_;
            return true;
        }
        std::string& text = tree_.unescaped_.emplace_back(text_.substr(begin, at_ - begin));
        while (!ended() && text_[at_] != '"') {
            if (static_cast<unsigned char>(text_[at_]) < 0x20) {
                return fail("a control character in a string: it must be escaped");
            }
            if (text_[at_] == '\\') {
                if (!escape(text)) {
                    return false;
                }
            } else {
                text.push_back(text_[at_++]);
            }
        }
        if (ended()) {
            return fail("the file ends within a string");
        }
        ++at_;
        result = text;
        return true;
    }

    bool escape(std::string& text) {
        ++at_;
        const char c = now();
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        if (const std::size_t known = letters.find(c); !ended() && known != std::string_view::npos) {
            text.push_back(meanings[known]);
            ++at_;
            return true;
        }
        std::uint32_t code = 0;
        if (!hex(code)) {
            return false;
        }
        if (code >= 0xD800 && code < 0xDC00) {  // the first half of a character beyond 16 bits
            std::uint32_t second = 0;
            if (now() != '\\' || (++at_, !hex(second)) || second < 0xDC00 || second > 0xDFFF) {
                return fail("half of a surrogate pair");
            }
            code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
        } else if (code >= 0xDC00 && code < 0xE000) {
            return fail("half of a surrogate pair");
        }
        append_utf8(text, code);
        return true;
    }

    bool hex(std::uint32_t& code) {
        const std::string_view digits = text_.substr(std::min(at_ + 1, text_.size()), 4);
        const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (now() != 'u' || digits.size() != 4 || parsed.ptr != digits.data() + 4) {
            return fail("no escape of JSON");
        }
        at_ += 5;
        return true;
    }

    JsonTree& tree_;
    std::string_view text_;
    JsonProblem& problem_;
    std::size_t at_ = 0;
    std::vector<std::uint32_t> open_;
};

bool JsonTree::parse(std::string_view text, JsonProblem& problem) {
    text_ = text;
    values_.clear();
    values_.reserve(std::min<std::size_t>(text.size() / 16, 1 << 16) + 1);
    unescaped_.clear();
    const bool parsed = JsonParser(*this, text, problem).parse();
    if (!parsed) {
        values_.clear();
    }
    return parsed;
}

}  // namespace lancer::gltf
