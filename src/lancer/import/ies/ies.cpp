#include "lancer/import/ies/ies.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"

namespace lancer {

namespace {

constexpr double most_candela = 1e12;
constexpr double angle_slack = 0.01;   // degrees by which files miss 90, 180 or 360
constexpr double border_width = 1e-3;  // degrees over which light begins where the first vertical angle is not 0

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_delimiter(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\v' || c == '\f' || ends_line(c); }

// Numbers between spaces, commas and ends of lines.
class Numbers {
public:
    Numbers(std::string_view text, int line, const std::string& file, Diagnostics& diagnostics)
        : text_(text), line_(line), file_(file), diagnostics_(diagnostics) {}

    // An error and nothing where there is none; after the first error always nothing.
    std::optional<double> next(std::string_view what, double least, double most) {
        while (!text_.empty() && is_delimiter(text_.front())) {
            step();
        }
        if (failed_) {
            return std::nullopt;
        }
        if (text_.empty()) {
            return fail(fmt::format("the file ends early: expected {}", what));
        }
        std::size_t length = 0;
        while (length < text_.size() && !is_delimiter(text_[length])) {
            ++length;
        }
        const std::string_view word = text_.substr(0, length);
        const char* first = word.data() + (word.front() == '+' ? 1 : 0);
        double value = 0.0;
        const auto [end, problem] = std::from_chars(first, word.data() + word.size(), value);
        if (problem == std::errc::invalid_argument || end != word.data() + word.size()) {
            return fail(fmt::format("{} is no number: expected {}", quoted(word), what));
        }
        if (problem != std::errc() || !(value >= least && value <= most)) {
            return fail(fmt::format("{} as {}: expected {:g} to {:g}", quoted(word), what, least, most));
        }
        text_.remove_prefix(length);
        return value;
    }

    bool next_list(std::string_view what, std::size_t count, double least, double most, std::vector<double>& list) {
        if (count > text_.size()) {  // each takes a byte at least
            fail(fmt::format("the file is too short for {} of {}", count, what));
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = next(what, least, most);
            if (!value) {
                return false;
            }
            list.push_back(*value);
        }
        return true;
    }

    std::nullopt_t fail(std::string message) {
        if (!failed_) {
            diagnostics_.error({file_, line_, 0}, std::move(message));
        }
        failed_ = true;
        return std::nullopt;
    }

    void warn(std::string message) { diagnostics_.warning({file_, line_, 0}, std::move(message)); }

private:
    void step() {
        const bool two = text_.front() == '\r' && text_.size() > 1 && text_[1] == '\n';
        line_ += ends_line(text_.front()) ? 1 : 0;
        text_.remove_prefix(two ? 2 : 1);
    }

    std::string_view text_;
    int line_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    bool failed_ = false;
};

bool rises(const std::vector<double>& angles) {
    return std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) == angles.end();
}

bool is_near(double a, double b) { return std::abs(a - b) <= angle_slack; }

// One row of candela for each horizontal angle.
struct Rows {
    std::vector<double> angles;
    std::vector<std::vector<double>> candela;

    void push(double angle, std::vector<double> row) {
        angles.push_back(angle);
        candela.push_back(std::move(row));
    }
};

// The other side of a plane of symmetry at `angle`.
void mirror(Rows& rows, double angle) {
    for (std::size_t i = rows.angles.size(); i-- > 0;) {
        if (!is_near(rows.angles[i], angle)) {
            rows.push(2.0 * angle - rows.angles[i], rows.candela[i]);
        }
    }
}

// All around the lamp, from 0 to 360.
Rows unfold(Rows rows, Numbers& numbers) {
    if (rows.angles.size() == 1) {
        rows.angles[0] = 0.0;
        return rows;
    }
    const double first = rows.angles.front(), last = rows.angles.back();
    if (is_near(first, 90.0) && is_near(last, 270.0)) {  // like on both sides of the plane through 90 and 270
        mirror(rows, 270.0);                             // up to 450, which is 90
        Rows turned;
        for (std::size_t i = 0; i < rows.angles.size(); ++i) {
            if (rows.angles[i] >= 360.0 - angle_slack) {
                turned.push(rows.angles[i] - 360.0, rows.candela[i]);
            }
        }
        if (turned.angles.empty() || !is_near(turned.angles.front(), 0.0)) {
            // No row at 360: between its neighbours.
            const auto after = std::upper_bound(rows.angles.begin(), rows.angles.end(), 360.0) - rows.angles.begin();
            const auto j = static_cast<std::size_t>(after);
            const double share = (360.0 - rows.angles[j - 1]) / (rows.angles[j] - rows.angles[j - 1]);
            std::vector<double> row;
            for (std::size_t k = 0; k < rows.candela[j].size(); ++k) {
                row.push_back(rows.candela[j - 1][k] * (1.0 - share) + rows.candela[j][k] * share);
            }
            turned.angles.insert(turned.angles.begin(), 0.0);
            turned.candela.insert(turned.candela.begin(), row);
        }
        turned.angles.front() = 0.0;
        for (std::size_t i = 0; i < rows.angles.size() && rows.angles[i] < 360.0 - angle_slack; ++i) {
            if (rows.angles[i] > turned.angles.back() + angle_slack) {
                turned.push(rows.angles[i], rows.candela[i]);
            }
        }
        turned.push(360.0, turned.candela.front());
        return turned;
    }
    if (is_near(last, 90.0)) {
        mirror(rows, 90.0);
        mirror(rows, 180.0);
    } else if (is_near(last, 180.0)) {
        mirror(rows, 180.0);
    } else if (!is_near(last, 360.0)) {
        numbers.warn(fmt::format("horizontal angles that end at {:g} instead of 0, 90, 180 or 360: taken to go on to the first one", last));
        rows.push(360.0, rows.candela.front());
    }
    rows.angles.front() = 0.0;
    rows.angles.back() = 360.0;
    return rows;
}

std::optional<scene::Photometry> read_numbers(Numbers& numbers, bool tilted) {
    if (tilted) {
        std::vector<double> left_out;
        const auto geometry = numbers.next("the lamp's position", 0.0, 10.0);
        const auto pairs = geometry ? numbers.next("the number of angles of tilt", 0.0, 1000.0) : std::nullopt;
        if (!pairs || !numbers.next_list("tilts", 2 * static_cast<std::size_t>(*pairs), -1e9, 1e9, left_out)) {
            return std::nullopt;
        }
        numbers.warn("factors for a tilted lamp are left out");
    }
    std::vector<double> head;
    if (!numbers.next_list("lamps, lumens, multiplier", 3, -1e9, 1e9, head) ||
        !numbers.next_list("the numbers of angles", 2, 1.0, 100000.0, head) || !numbers.next_list("type and units", 2, 1.0, 3.0, head) ||
        !numbers.next_list("the lamp's size", 3, -1e9, 1e9, head) || !numbers.next_list("ballast factors and watts", 3, -1e9, 1e9, head)) {
        return std::nullopt;
    }
    // The one that stands for future use has been a factor, too, before 1991.
    const double factor = head[2] * head[10];
    const auto down = static_cast<std::size_t>(head[3]), around = static_cast<std::size_t>(head[4]);
    if (head[3] != std::floor(head[3]) || head[4] != std::floor(head[4])) {
        return numbers.fail("the numbers of angles must be whole");
    }
    if (head[5] != 1.0) {
        return numbers.fail(fmt::format("photometry of type {}: only type C, 1, is read", head[5] == 2.0 ? "B, 2" : "A, 3"));
    }
    if (!(factor > 0.0)) {
        return numbers.fail(fmt::format("the factors of all intensities come to {:g}: expected more than 0", factor));
    }
    scene::Photometry photometry;
    Rows rows;
    if (!numbers.next_list("vertical angles", down, 0.0, 180.0, photometry.vertical) ||
        !numbers.next_list("horizontal angles", around, 0.0, 360.0, rows.angles)) {
        return std::nullopt;
    }
    if (down < 2 || !rises(photometry.vertical) || !rises(rows.angles)) {
        return numbers.fail("angles must rise, and there must be two vertical ones at least");
    }
    if (around > 1 && !is_near(rows.angles.front(), 0.0) && !(is_near(rows.angles.front(), 90.0) && is_near(rows.angles.back(), 270.0))) {
        return numbers.fail("horizontal angles must start at 0, or go from 90 to 270");
    }
    const bool starts_late = photometry.vertical.front() > 0.0;
    for (std::size_t i = 0; i < around; ++i) {
        std::vector<double> row;
        if (!numbers.next_list("candela", down, 0.0, most_candela, row)) {
            return std::nullopt;
        }
        for (double& candela : row) {
            candela = std::min(candela * factor, most_candela);
        }
        if (starts_late) {
            row.insert(row.begin(), {0.0, 0.0});
        }
        rows.candela.push_back(std::move(row));
    }
    if (starts_late) {
        const double first = photometry.vertical.front();
        photometry.vertical.insert(photometry.vertical.begin(), {0.0, std::max(first - border_width, 0.5 * first)});
    }
    rows = unfold(std::move(rows), numbers);
    photometry.horizontal = rows.angles;
    for (const std::vector<double>& row : rows.candela) {
        photometry.candela.insert(photometry.candela.end(), row.begin(), row.end());
    }
    if (*std::max_element(photometry.candela.begin(), photometry.candela.end()) == 0.0) {
        numbers.warn("all intensities are 0");
    }
    return photometry;
}

}  // namespace

std::optional<scene::Photometry> read_ies(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    int line = 1;
    for (std::string_view rest = text; !rest.empty(); ++line) {
        const std::size_t length = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), ends_line) - rest.begin());
        const std::string_view here = rest.substr(0, length);
        const bool two = length + 1 < rest.size() && rest[length] == '\r' && rest[length + 1] == '\n';
        rest.remove_prefix(std::min(length + (two ? 2 : 1), rest.size()));
        if (here.substr(0, 5) == "TILT=") {
            std::string_view tilt = here.substr(5);
            tilt = tilt.substr(0, tilt.find_last_not_of(" \t") + 1);
            if (tilt != "NONE" && tilt != "INCLUDE") {
                diagnostics.warning({file, line, 6}, fmt::format("tilt from the file {} is left out", quoted(tilt)));
            }
            Numbers numbers(rest, line + 1, file, diagnostics);
            return read_numbers(numbers, tilt == "INCLUDE");
        }
    }
    diagnostics.error({file, 0, 0}, "no line that begins with TILT=: this is no photometric file (ANSI/IES LM-63)");
    return std::nullopt;
}

}  // namespace lancer
