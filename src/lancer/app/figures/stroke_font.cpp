#include "lancer/app/figures/stroke_font.h"

#include <array>
#include <cstddef>

namespace lancer::app {

namespace {

// Strokes are separated by spaces. Each is a row of points of two digits, x from 0 to 4 and y from 0 (where descenders end) over 2 (the base
// line) and 6 (the height of small letters) to 8 (the height of capitals).
struct Glyph {
    char letter;
    std::string_view strokes;
};

constexpr std::array glyphs = {
    Glyph{'0', "030718384743321203"},
    Glyph{'1', "072822 0242"},
    Glyph{'2', "07183847460242"},
    Glyph{'3', "0718384746354443321203 1535"},
    Glyph{'4', "32380444"},
    Glyph{'5', "4808053544433202"},
    Glyph{'6', "4738180703123243443505"},
    Glyph{'7', "084812"},
    Glyph{'8', "15060718384746351504031232434435"},
    Glyph{'9', "0312324347381807061545"},
    Glyph{'.', "1222"},
    Glyph{',', "2211"},
    Glyph{'-', "1535"},
    Glyph{'+', "0545 2723"},
    Glyph{':', "1222 1525"},
    Glyph{'(', "38272332"},
    Glyph{')', "18272312"},
    Glyph{'/', "0248"},
    Glyph{'a', "0516364542 441403123243"},
    Glyph{'b', "0802 0516364543321203"},
    Glyph{'c', "4536160503123243"},
    Glyph{'d', "4842 4536160503123243"},
    Glyph{'e', "044445361605031242"},
    Glyph{'f', "47382722 1646"},
    Glyph{'g', "4641301001 4536160503123243"},
    Glyph{'h', "0802 0516364542"},
    Glyph{'i', "2226 2728"},
    Glyph{'j', "36312010 3738"},
    Glyph{'k', "0802 4604 2542"},
    Glyph{'l', "2822"},
    Glyph{'m', "0602 05162522 25364542"},
    Glyph{'n', "0602 0516364542"},
    Glyph{'o', "030516364543321203"},
    Glyph{'p', "0600 0516364543321203"},
    Glyph{'q', "4640 4536160503123243"},
    Glyph{'r', "0602 05163645"},
    Glyph{'s', "45361605143443321203"},
    Glyph{'t', "282332 1636"},
    Glyph{'u', "0603123243 4642"},
    Glyph{'v', "062246"},
    Glyph{'w', "0612263246"},
    Glyph{'x', "0246 0642"},
    Glyph{'y', "0622 461000"},
    Glyph{'z', "06460242"},
    Glyph{'A', "022842 1434"},
    Glyph{'C', "4738180703123243"},
    Glyph{'F', "480802 0535"},
    Glyph{'H', "0802 4842 0545"},
    Glyph{'I', "2822 1838 1232"},
    Glyph{'L', "080242"},
    Glyph{'M', "0208254842"},
    Glyph{'O', "030718384743321203"},
    Glyph{'P', "02083847463505"},
    Glyph{'S', "473818070615354443321203"},
    Glyph{'T', "0848 2822"},
    Glyph{'U', "080312324348"},
};

constexpr std::string_view unknown_letter = "0208484202";
constexpr double advance = 5.5;
constexpr double narrow_advance = 3.0;  // of letters that are one stroke wide, which stand in the middle of their cell
constexpr double unit = 1.0 / 6.0;      // capitals are 6 high in the table

std::string_view strokes_of(char letter) {
    for (const Glyph& glyph : glyphs) {
        if (glyph.letter == letter) {
            return glyph.strokes;
        }
    }
    return unknown_letter;
}

bool is_narrow(char letter) { return std::string_view("il.,: ").find(letter) != std::string_view::npos; }

double advance_of(char letter) { return (is_narrow(letter) ? narrow_advance : advance) * unit; }

}  // namespace

std::vector<std::vector<glm::dvec2>> text_strokes(std::string_view text) {
    std::vector<std::vector<glm::dvec2>> strokes;
    double start = 0.0;
    for (const char letter : text) {
        const double shift = is_narrow(letter) ? -1.25 : 0.0;
        std::string_view rest = letter == ' ' ? std::string_view() : strokes_of(letter);
        while (!rest.empty()) {
            const std::size_t end = rest.find(' ');
            const std::string_view stroke = rest.substr(0, end);
            rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
            std::vector<glm::dvec2>& points = strokes.emplace_back();
            for (std::size_t i = 0; i + 1 < stroke.size(); i += 2) {
                points.emplace_back(start + (stroke[i] - '0' + shift) * unit, (stroke[i + 1] - '2') * unit);
            }
        }
        start += advance_of(letter);
    }
    return strokes;
}

double text_width(std::string_view text) {
    double width = 0.0;
    for (const char letter : text) {
        width += advance_of(letter);
    }
    return text.empty() ? 0.0 : width - (advance - 4.0) * unit;
}

}  // namespace lancer::app
