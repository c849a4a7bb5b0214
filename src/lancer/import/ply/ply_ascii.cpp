#include <fmt/format.h>

#include <algorithm>

#include "lancer/import/mesh/text_cursor.h"
#include "lancer/import/ply/ply_data.h"

namespace lancer::ply {

namespace {

class AsciiReader {
public:
    AsciiReader(std::string_view body, const Header& header, Data& data, MeshMessages& messages)
        : cursor_(body, false, '\0'), lines_before_(header.lines), header_(header), data_(data), messages_(messages) {}

    void run() {
        for (const Element& element : header_.elements) {
            if (!read(element)) {
                return;
            }
        }
    }

private:
    bool error(std::string message) {
        messages_.error(lines_before_ + cursor_.line(), cursor_.column(), std::move(message));
        return false;
    }

    bool ended_early(const Element& element, std::uint64_t read_so_far) {
        return error(fmt::format("the file ends after {} of {} {} elements", read_so_far, element.count, quoted(element.name)));
    }

    bool read(const Element& element) {
        if (element.properties.empty()) {
            return true;
        }
        // Every number takes a digit, and a blank but for the last one.
        if (element.count > (cursor_.bytes_left() + 1) / (2 * element.properties.size())) {
            messages_.error(element.line, 1,
                            fmt::format("{} {} elements do not fit into the {} bytes that follow", element.count, quoted(element.name),
                                        cursor_.bytes_left()));
            return false;
        }
        const Meaning meaning = meaning_of(element);
        std::vector<Destination> to(element.properties.size());
        if (meaning == Meaning::vertices) {
            const Columns columns = vertex_columns(element);
            const auto all = make_room(data_.mesh, static_cast<std::size_t>(element.count), columns);
            for (std::size_t role = 0; role < role_count; ++role) {
                if (columns[role] >= 0) {
                    to[static_cast<std::size_t>(columns[role])] = all[role];
                }
            }
        }
        const int corners = meaning == Meaning::faces || meaning == Meaning::strips ? corner_list(element) : -1;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                if (!cursor_.find_word_on_any_line()) {
                    return ended_early(element, i);
                }
                const Property& property = element.properties[p];
                const bool good =
                    property.is_list ? read_list(element, i, static_cast<int>(p) == corners, meaning) : read_scalar(property, to[p], i);
                if (!good) {
                    return false;
                }
            }
        }
        return true;
    }

    bool read_scalar(const Property& property, const Destination& to, std::uint64_t i) {
        if (!to.first) {
            cursor_.skip(cursor_.word().size());
            return true;
        }
        return cursor_.read_number(to.first[i * to.stride]) ||
               error(fmt::format("{} needs a finite number, not {}", quoted(property.name), quoted(cursor_.word())));
    }

    bool read_list(const Element& element, std::uint64_t i, bool wanted, Meaning meaning) {
        std::int64_t count = 0;
        if (!whole_number(count, "the length of a list")) {
            return false;
        }
        if (count < 0 || static_cast<std::uint64_t>(count) > (cursor_.bytes_left() + 1) / 2) {
            return error(fmt::format("a list can't have {} entries: {} bytes are left", count, cursor_.bytes_left()));
        }
        list_.clear();
        for (std::int64_t k = 0; k < count; ++k) {
            if (!cursor_.find_word_on_any_line()) {
                return ended_early(element, i);
            }
            std::int64_t number = 0;
            if (!wanted) {
                cursor_.skip(cursor_.word().size());
            } else if (!whole_number(number, "a corner")) {
                return false;
            } else if (number < (meaning == Meaning::strips ? -1 : 0) || number > 0xffffffff) {
                return error(fmt::format("there is no vertex {}", number));
            } else {
                list_.push_back(static_cast<std::uint32_t>(number));
            }
        }
        if (wanted && meaning == Meaning::strips) {
            data_.add_strip(list_.data(), list_.size());
        } else if (wanted) {
            data_.add_face(list_.data(), list_.size());
        }
        return true;
    }

    bool whole_number(std::int64_t& number, const char* what) {
        const std::string_view word = cursor_.word();
        if (cursor_.read_integer(number) && cursor_.at_word_end()) {
            return true;
        }
        return error(fmt::format("{} must be a whole number, not {}", what, quoted(word)));
    }

    TextCursor cursor_;
    int lines_before_;
    const Header& header_;
    Data& data_;
    MeshMessages& messages_;
    std::vector<std::uint32_t> list_;
};

}  // namespace

void read_ascii(std::string_view body, const Header& header, Data& data, MeshMessages& messages) {
    // The cursor counts the first line of the body as line 1.
    AsciiReader(body, header, data, messages).run();
}

}  // namespace lancer::ply
