#include "lancer/spectrum/curve_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "lancer/base/file.h"

namespace lancer {
namespace {

constexpr std::size_t largest_file = std::size_t{16} << 20;  // bytes
constexpr double largest_number = 1e100;
constexpr int most_errors = 10;  // a file of another kind has one on every line

struct Field {
    std::string_view text;
    int column = 0;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

// Between fields stand spaces, or one comma or semicolon with or without spaces. Two commas enclose an empty field.
std::vector<Field> split(std::string_view line) {
    std::vector<Field> fields;
    std::size_t i = 0;
    const auto skip_spaces = [&] {
        while (i < line.size() && is_space(line[i])) {
            ++i;
        }
    };
    skip_spaces();
    while (i < line.size()) {
        const std::size_t start = i;
        while (i < line.size() && !is_space(line[i]) && line[i] != ',' && line[i] != ';') {
            ++i;
        }
        fields.push_back({line.substr(start, i - start), static_cast<int>(start) + 1});
        skip_spaces();
        if (i < line.size() && (line[i] == ',' || line[i] == ';')) {
            ++i;
            skip_spaces();
        }
    }
    return fields;
}

std::optional<double> to_number(std::string_view text) {
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // from_chars also knows "inf" and "nan", which measure nothing; and differences must stay finite.
    if (error != std::errc() || end != text.data() + text.size() || !(std::fabs(value) <= largest_number)) {
        return std::nullopt;
    }
    return value;
}

// What a message can show of bytes that may be anything.
std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 24;
    std::string result = "\"";
    for (const char c : text.substr(0, longest)) {
        result += c >= ' ' && c <= '~' ? c : '?';
    }
    return result + (text.size() > longest ? "...\"" : "\"");
}

std::string what_is_expected(int columns) {
    return columns == 1 ? "a wavelength in nm and a value" : "a wavelength in nm and " + std::to_string(columns) + " values";
}

struct Row {
    int line = 0;
    std::vector<double> values;
};

class CurveParser {
public:
    CurveParser(const std::string& file, int columns, Diagnostics& diagnostics)
        : file_(file), columns_(columns), diagnostics_(diagnostics) {}

    void parse(std::string_view text) {
        if (text.substr(0, 3) == "\xEF\xBB\xBF") {
            text.remove_prefix(3);
        }
        for (int line = 1; !text.empty() && errors_ < most_errors; ++line) {
            const std::size_t length = std::min(text.find('\n'), text.size());
            parse_line(text.substr(0, length), line);
            text.remove_prefix(std::min(length + 1, text.size()));
        }
        if (errors_ == 0 && rows_.empty()) {
            error(0, 0, "no values: expected lines with " + what_is_expected(columns_));
        }
    }

    std::optional<std::vector<SpectralCurve>> curves(SpectralCurve::Beyond beyond) {
        if (errors_ == 0) {
            sort();
        }
        if (errors_ > 0) {
            return std::nullopt;
        }
        warn_of_units();
        std::vector<SpectralCurve> result;
        std::vector<double> nanometres;
        for (const Row& row : rows_) {
            nanometres.push_back(row.values[0]);
        }
        for (std::size_t c = 1; c <= static_cast<std::size_t>(columns_); ++c) {
            std::vector<double> values;
            for (const Row& row : rows_) {
                values.push_back(row.values[c]);
            }
            result.emplace_back(nanometres, std::move(values), beyond);
        }
        return result;
    }

private:
    void error(int line, int column, std::string message) {
        diagnostics_.error({file_, line, column}, std::move(message));
        ++errors_;
    }

    void parse_line(std::string_view line, int number) {
        line = line.substr(0, line.find('#'));
        const std::vector<Field> fields = split(line);
        if (fields.empty()) {
            return;
        }
        const bool may_name_columns = std::exchange(first_line_, false);
        if (may_name_columns && std::none_of(fields.begin(), fields.end(), [](const Field& f) { return to_number(f.text).has_value(); })) {
            return;
        }
        Row row{number, {}};
        for (const Field& field : fields) {
            const std::optional<double> value = to_number(field.text);
            if (!value) {
                return error(number, field.column, "expected a number, found " + quoted(field.text));
            }
            row.values.push_back(*value);
        }
        if (static_cast<int>(fields.size()) != columns_ + 1) {
            const bool commas = line.find(',') != std::string_view::npos && fields.size() > 2;
            return error(number, fields.front().column,
                         "expected " + what_is_expected(columns_) + ", found " + std::to_string(fields.size()) +
                             (fields.size() == 1 ? " number" : " numbers") + (commas ? " (decimals are written with a point)" : ""));
        }
        if (!(row.values.front() > 0.0)) {
            return error(number, fields.front().column, "expected a wavelength above 0 nm, found " + quoted(fields.front().text));
        }
        rows_.push_back(std::move(row));
    }

    void sort() {
        std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.values[0] < b.values[0]; });
        std::vector<Row> once;
        for (Row& row : rows_) {
            if (once.empty() || once.back().values[0] < row.values[0]) {
                once.push_back(std::move(row));
            } else if (once.back().values != row.values && errors_ < most_errors) {
                error(row.line, 1,
                      "this wavelength has another value in line " + std::to_string(once.back().line) + ": expected each wavelength once");
            }
        }
        rows_ = std::move(once);
    }

    void warn_of_units() {
        const double first = rows_.front().values[0], last = rows_.back().values[0];
        if (last < 360.0 || first > 830.0) {
            diagnostics_.warning({file_, rows_.front().line, 1}, std::string("no wavelength between 360 and 830 nm") +
                                                                     (last < 30.0      ? ": are these micrometres? Lancer reads nanometres"
                                                                      : first > 2000.0 ? ": are these angstroms? Lancer reads nanometres"
                                                                                       : ""));
        }
    }

    const std::string& file_;
    const int columns_;
    Diagnostics& diagnostics_;
    std::vector<Row> rows_;
    int errors_ = 0;
    bool first_line_ = true;
};

}  // namespace

std::optional<std::vector<SpectralCurve>> parse_curves(std::string_view text, const std::string& file, int columns,
                                                       SpectralCurve::Beyond beyond, Diagnostics& diagnostics) {
    CurveParser parser(file, columns, diagnostics);
    parser.parse(text);
    return parser.curves(beyond);
}

std::optional<SpectralCurve> read_curve(const std::string& path, const SourcePosition& named_at, SpectralCurve::Beyond beyond,
                                        Diagnostics& diagnostics) {
    const std::optional<FileBytes> bytes = read_file(path, named_at, diagnostics, largest_file);
    if (!bytes) {
        return std::nullopt;
    }
    const auto curves = parse_curves(bytes->view(), path, 1, beyond, diagnostics);
    return curves ? std::optional(curves->front()) : std::nullopt;
}

}  // namespace lancer
