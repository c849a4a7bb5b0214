#include "lancer/import/obj/obj_parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "lancer/import/mesh/text_cursor.h"

namespace lancer::obj {

namespace {

// Statements that say nothing about the shape of the faces, or that we leave out knowingly (SUPPORT.md).
constexpr std::array passed_over = {"s", "mg", "usemap", "maplib", "vp", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};
constexpr std::array not_faces = {"l", "p"};

template <std::size_t count>
bool contains(const std::array<const char*, count>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class Parser {
public:
    Parser(std::string_view bytes, MeshMessages& messages) : cursor_(bytes, true, '#'), messages_(messages) {}

    Statements run() {
        while (!cursor_.at_end() && !messages_.has_too_many_errors()) {
            if (cursor_.find_word()) {
                statement();
            }
            cursor_.next_line();
        }
        check_late_corners();
        return std::move(result_);
    }

private:
    struct LateCorner {  // names something that may still come
        std::int64_t number;
        const char* of;  // which list
        int line, column;
    };

    void statement() {
        const std::string_view word = cursor_.word();
        const int line = cursor_.line();
        const int column = cursor_.column();
        cursor_.skip(word.size());
        if (word == "v") {
            vertex();
        } else if (word == "vt") {
            glm::vec2 uv(0.0f);
            numbers(1, 2, "a texture coordinate", &uv.x);
            result_.uvs.push_back(uv);
        } else if (word == "vn") {
            glm::vec3 n(0.0f);
            numbers(3, 3, "a normal", &n.x);
            result_.normals.push_back(n);
        } else if (word == "f" || word == "fo") {
            face(line, column);
        } else if (contains(not_faces, word)) {
            ++result_.lines_and_points;
        } else if (word == "usemtl") {
            run_.material = number_of(materials_, result_.materials);
            begin_run();
        } else if (word == "o" || word == "g") {
            run_.name = number_of(names_, result_.names);
            begin_run();
        } else if (word == "mtllib") {
            if (cursor_.find_word()) {
                result_.libraries.push_back({cursor_.rest_of_line(), line, column});
            }
        } else if (!contains(passed_over, word)) {
            messages_.warning(line, column, fmt::format("unknown statement {}; left out", quoted(word)));
        }
    }

    // Three coordinates, perhaps a weight, perhaps a colour.
    void vertex() {
        float values[7] = {};
        const int count = numbers(3, 7, "a vertex", values);
        result_.positions.emplace_back(values[0], values[1], values[2]);
        if (count >= 6) {
            const float* rgb = values + (count - 3);
            result_.colors.resize(result_.positions.size(), glm::vec3(1.0f));
            result_.colors.back() = {rgb[0], rgb[1], rgb[2]};
        } else if (!result_.colors.empty()) {
            result_.colors.emplace_back(1.0f);
        }
    }

    // At least `least` numbers must follow; what comes after the first `most` is passed over. Returns how many there are.
    int numbers(int least, int most, const char* what, float* values) {
        for (int i = 0; i < most; ++i) {
            if (!cursor_.find_word()) {
                if (i < least) {
                    messages_.error(cursor_.line(), cursor_.column(),
                                    fmt::format("{} needs {} numbers, but the line ends after {}", what, least, i));
                }
                return i;
            }
            if (!cursor_.read_number(values[i])) {
                messages_.error(cursor_.line(), cursor_.column(),
                                fmt::format("{} needs finite numbers, not {}", what, quoted(cursor_.word())));
                return i;
            }
        }
        return most;
    }

    void face(int line, int column) {
        const std::size_t first = result_.corners.size();
        while (cursor_.find_word()) {
            Corner corner;
            if (!read_corner(corner)) {
                result_.corners.resize(first);
                return;
            }
            result_.corners.push_back(corner);
        }
        if (const std::size_t count = result_.corners.size() - first; count < 3) {
            messages_.warning(line, column, fmt::format("a face needs three corners, not {}; left out", count));
            result_.corners.resize(first);
            return;
        }
        result_.face_ends.push_back(result_.corners.size());
    }

    // a, a/b, a//c or a/b/c
    bool read_corner(Corner& corner) {
        const int line = cursor_.line();
        const int column = cursor_.column();
        const std::string_view word = cursor_.word();
        bool good = index(corner.position, result_.positions.size(), "vertex");
        if (good && cursor_.take('/')) {
            if (!cursor_.stands('/') && !cursor_.at_word_end()) {
                good = index(corner.uv, result_.uvs.size(), "texture coordinate");
            }
            if (good && cursor_.take('/') && !cursor_.at_word_end()) {
                good = index(corner.normal, result_.normals.size(), "normal");
            }
        }
        if (good && !cursor_.at_word_end()) {
            good = false;
            messages_.error(
                line, column,
                fmt::format("a corner is written as vertex, vertex/uv, vertex//normal or vertex/uv/normal, not {}", quoted(word)));
        }
        return good;
    }

    // Counted from 1, or backwards from -1, the last one so far.
    bool index(std::int32_t& result, std::size_t count, const char* of) {
        const int line = cursor_.line();
        const int column = cursor_.column();
        std::int64_t number = 0;
        if (!cursor_.read_integer(number)) {
            messages_.error(line, column, fmt::format("the number of a {} is missing here, found {}", of, quoted(cursor_.word())));
            return false;
        }
        const std::int64_t have = static_cast<std::int64_t>(count);
        if (number == 0) {
            messages_.error(line, column, fmt::format("there is no {} 0: they are counted from 1", of));
            return false;
        }
        if (number < -have || number > std::numeric_limits<std::int32_t>::max()) {
            messages_.error(line, column, fmt::format("there is no {} {}: {} came before", of, number, have));
            return false;
        }
        if (number > have) {
            late_.push_back({number, of, line, column});
        }
        result = static_cast<std::int32_t>(number < 0 ? have + number : number - 1);
        return true;
    }

    void check_late_corners() {
        for (const LateCorner& late : late_) {
            const std::string_view of = late.of;
            const std::size_t count = of == "vertex"   ? result_.positions.size()
                                      : of == "normal" ? result_.normals.size()
                                                       : result_.uvs.size();
            if (late.number > static_cast<std::int64_t>(count)) {
                messages_.error(late.line, late.column, fmt::format("there is no {} {}: the file has {}", of, late.number, count));
            }
        }
    }

    // The rest of the line is a name.
    std::int32_t number_of(std::map<std::string, std::int32_t>& known, std::vector<std::string>& names) {
        const std::string name = cursor_.find_word() ? cursor_.rest_of_line() : "";
        const auto [found, is_new] = known.try_emplace(name, static_cast<std::int32_t>(names.size()));
        if (is_new) {
            names.push_back(name);
        }
        return found->second;
    }

    void begin_run() {
        run_.first_face = result_.face_ends.size();
        if (!result_.runs.empty() && result_.runs.back().first_face == run_.first_face) {
            result_.runs.back() = run_;
        } else {
            result_.runs.push_back(run_);
        }
    }

    TextCursor cursor_;
    MeshMessages& messages_;
    Statements result_;
    std::vector<LateCorner> late_;
    Run run_;
    std::map<std::string, std::int32_t> materials_;
    std::map<std::string, std::int32_t> names_;
};

}  // namespace

Statements parse(std::string_view bytes, MeshMessages& messages) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv)) {
        messages.error(1, 1, "this is UTF-16 text; save the file as UTF-8");
        return {};
    }
    if (bytes.starts_with("\xef\xbb\xbf"sv)) {
        bytes.remove_prefix(3);
    }
    return Parser(bytes, messages).run();
}

}  // namespace lancer::obj
