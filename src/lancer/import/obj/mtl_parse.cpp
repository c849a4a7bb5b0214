#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mesh/text_cursor.h"
#include "lancer/import/obj/mtl.h"

namespace lancer::obj {

namespace {

std::string lower(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

constexpr std::array numbers_of = {"kd",    "ka", "ks", "ke", "tf", "ns",  "ni",    "d",     "tr",
                                   "illum", "pr", "pm", "ps", "pc", "pcr", "aniso", "anisor"};
constexpr std::array maps_of = {"map_kd", "map_ka", "map_ks", "map_ke", "map_ns", "map_d",  "map_bump", "bump",    "norm",
                                "map_kn", "disp",   "refl",   "map_pr", "map_pm", "map_ps", "map_pc",   "map_pcr", "decal"};

template <std::size_t count>
bool contains(const std::array<const char*, count>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class Parser {
public:
    Parser(std::string_view bytes, const std::string& file, ImportContext& context)
        : cursor_(bytes, true, '#'), file_(file), context_(context), messages_(file, context.diagnostics) {}

    std::vector<MaterialStatements> run() {
        while (!cursor_.at_end()) {
            if (cursor_.find_word()) {
                statement();
            }
            cursor_.next_line();
        }
        return std::move(all_);
    }

private:
    SourcePosition here() const { return {file_, cursor_.line(), cursor_.column()}; }

    void statement() {
        const SourcePosition position = here();
        const std::string_view written = cursor_.word();
        const std::string word = lower(written);
        cursor_.skip(written.size());
        if (word == "newmtl") {
            MaterialStatements material;
            material.name = cursor_.find_word() ? cursor_.rest_of_line() : "";
            material.position = position;
            is_kept_ = names_.insert(material.name).second;
            if (is_kept_) {
                all_.push_back(std::move(material));
            } else {
                messages_.warning(position.line, position.column,
                                  fmt::format("material {} comes again; the first counts", quoted(material.name)));
            }
        } else if (!contains(numbers_of, word) && !contains(maps_of, word)) {
            context_.report.dropped(fmt::format("MTL {}", quoted(written)), "lancer does not know it", position);
        } else if (all_.empty()) {
            messages_.warning(position.line, position.column, fmt::format("{} stands before the first newmtl; left out", quoted(written)));
        } else if (is_kept_ && contains(numbers_of, word)) {
            numbers(word, position);
        } else if (is_kept_) {
            map(word, position);
        }
    }

    void numbers(const std::string& word, const SourcePosition& position) {
        std::vector<double> values;
        while (values.size() < 3 && cursor_.find_word()) {
            float value = 0.0f;
            if (values.empty() && (cursor_.word() == "spectral" || cursor_.word() == "xyz")) {
                context_.report.dropped(fmt::format("MTL {} {}", word, cursor_.word()), "only RGB is read", position);
                return;
            }
            if (cursor_.word() == "-halo") {
                cursor_.skip(5);
                continue;
            }
            if (!cursor_.read_number(value)) {
                messages_.warning(cursor_.line(), cursor_.column(),
                                  fmt::format("{} needs numbers, not {}; left out", word, quoted(cursor_.word())));
                return;
            }
            values.push_back(static_cast<double>(value));
        }
        if (values.empty() || values.size() == 2) {
            messages_.warning(position.line, position.column, fmt::format("{} needs one or three numbers; left out", word));
            return;
        }
        all_.back().numbers[word] = values;
    }

    // Up to `most` numbers that follow an option; what is not written stays.
    void option_numbers(double* values, int most) {
        for (int i = 0; i < most && cursor_.find_word(); ++i) {
            float value = 0.0f;
            if (!cursor_.read_number(value)) {
                return;
            }
            values[i] = static_cast<double>(value);
        }
    }

    std::string_view option_word() {
        const std::string_view word = cursor_.find_word() ? cursor_.word() : std::string_view();
        cursor_.skip(word.size());
        return word;
    }

    void map(const std::string& word, const SourcePosition& position) {
        Map map;
        map.position = position;
        while (cursor_.find_word() && cursor_.word().starts_with('-')) {
            const std::string option = lower(option_word());
            double values[3] = {0.0, 0.0, 0.0};
            if (option == "-o") {
                option_numbers(values, 3);
                map.offset = {values[0], values[1]};
            } else if (option == "-s") {
                values[0] = values[1] = 1.0;
                option_numbers(values, 3);
                map.scale = {values[0], values[1]};
            } else if (option == "-t") {
                option_numbers(values, 3);
                context_.report.dropped("MTL -t", "turbulence of pictures", position);
            } else if (option == "-mm") {
                values[1] = 1.0;
                option_numbers(values, 2);
                map.base = values[0];
                map.gain = values[1];
            } else if (option == "-bm") {
                values[0] = 1.0;
                option_numbers(values, 1);
                map.bump = values[0];
            } else if (option == "-clamp") {
                map.clamps = option_word() == "on";
            } else if (option == "-imfchan") {
                const std::string_view channel = option_word();
                map.channel = channel.empty() ? '\0' : channel.front();
            } else if (option == "-type") {
                const std::string_view type = option_word();
                context_.report.dropped(fmt::format("MTL -type {}", quoted(type)), "pictures lie over texture coordinates", position);
            } else {  // such as -blendu, -texres, -boost, -cc, -colorspace: they change hardly anything
                option_word();
            }
        }
        map.file = cursor_.rest_of_line();
        std::replace(map.file.begin(), map.file.end(), '\\', '/');
        if (map.file.empty()) {
            messages_.warning(position.line, position.column, fmt::format("{} names no file; left out", word));
            return;
        }
        all_.back().maps[word] = std::move(map);
    }

    TextCursor cursor_;
    const std::string& file_;
    ImportContext& context_;
    MeshMessages messages_;
    std::vector<MaterialStatements> all_;
    std::set<std::string> names_;
    bool is_kept_ = true;
};

}  // namespace

std::optional<double> MaterialStatements::number(const char* key) const {
    const auto found = numbers.find(key);
    return found == numbers.end() ? std::nullopt : std::optional<double>(found->second.front());
}

std::optional<glm::dvec3> MaterialStatements::color(const char* key) const {
    const auto found = numbers.find(key);
    if (found == numbers.end()) {
        return std::nullopt;
    }
    const std::vector<double>& v = found->second;
    return v.size() < 3 ? glm::dvec3(v[0]) : glm::dvec3(v[0], v[1], v[2]);
}

const Map* MaterialStatements::map(const char* key) const {
    const auto found = maps.find(key);
    return found == maps.end() ? nullptr : &found->second;
}

std::vector<MaterialStatements> parse_materials(std::string_view bytes, const std::string& file, ImportContext& context) {
    if (bytes.starts_with("\xef\xbb\xbf")) {
        bytes.remove_prefix(3);
    }
    return Parser(bytes, file, context).run();
}

}  // namespace lancer::obj
