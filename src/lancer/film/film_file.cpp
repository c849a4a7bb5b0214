#include "lancer/film/film_file.h"

#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "lancer/base/failure.h"
#include "lancer/base/hash.h"
#include "lancer/image/replace_file.h"

namespace lancer {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "lancer film\r\n\x1a\n\0"sv;  // as PNG's: shows what text transfers do to it
constexpr std::uint32_t format_version = 2;
constexpr std::uint32_t end_mark = 0xffffffffu;
constexpr std::uint32_t splats_mark = 0xfffffffeu;
constexpr int largest_side = 65536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

void put_texts(const std::vector<std::string>& texts, ByteWriter& bytes) {
    bytes.put(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts) {
        bytes.put_text(text);
    }
}

std::string encode_head(const FilmAbout& about, const FilmShape& shape) {
    ByteWriter head;
    for (const int number :
         {shape.width, shape.height, shape.tile_size, int{shape.sums}, int{shape.layers.variance}, int{shape.layers.direct},
          int{shape.layers.surface}, int{shape.layers.ids}, shape.layers.spectral_bins, int{shape.layers.splats}, int{shape.layers.runs}}) {
        head.put(std::int32_t{number});
    }
    head.put(shape.layers.clamp);
    head.put(static_cast<std::uint64_t>(about.texts.size()));
    for (const auto& [key, text] : about.texts) {
        head.put_text(key);
        head.put_text(text);
    }
    head.put(static_cast<std::uint64_t>(about.lists.size()));
    for (const auto& [key, texts] : about.lists) {
        head.put_text(key);
        put_texts(texts, head);
    }
    return head.bytes();
}

bool decode_head(std::string_view bytes, FilmAbout& about, FilmShape& shape) {
    ByteReader head(bytes);
    const auto number = [&] {
        std::int32_t value = 0;
        head.get(value);
        return static_cast<int>(value);
    };
    const auto count = [&] {
        std::uint64_t value = 0;
        head.get(value);
        return value;
    };
    shape.width = number();
    shape.height = number();
    shape.tile_size = number();
    shape.sums = number() != 0;
    shape.layers.variance = number() != 0;
    shape.layers.direct = number() != 0;
    shape.layers.surface = number() != 0;
    shape.layers.ids = number() != 0;
    shape.layers.spectral_bins = number();
    shape.layers.splats = number() != 0;
    shape.layers.runs = number() != 0;
    head.get(shape.layers.clamp);
    for (std::uint64_t i = 0, n = count(); i < n && head.good(); ++i) {
        const std::string key = head.get_text();
        about.texts[key] = head.get_text();
    }
    for (std::uint64_t i = 0, n = count(); i < n && head.good(); ++i) {
        std::vector<std::string>& list = about.lists[head.get_text()];
        for (std::uint64_t j = 0, m = count(); j < m && head.good(); ++j) {
            list.push_back(head.get_text());
        }
    }
    const auto within = [](int value, int low, int high) { return value >= low && value <= high; };
    return head.good() && head.left() == 0 && within(shape.width, 1, largest_side) && within(shape.height, 1, largest_side) &&
           std::int64_t{shape.width} * shape.height <= most_pixels && within(shape.tile_size, 1, largest_side) &&
           within(shape.layers.spectral_bins, 0, 4096);
}

// A tile's number, its rounds, so many bytes, and the checksum of all these.
void seal(std::uint32_t tile, std::uint32_t rounds, const std::string& payload, ByteWriter& record) {
    record.clear();
    record.put(tile);
    record.put(rounds);
    record.put_text(payload);
    record.put(hash_bytes(record.bytes()));
}

// All of a film with splats at one moment.
struct WholeFilm {
    WholeFilm(const FilmState& state, const SplatSums& sums) {
        const auto lock = state.lock_all();
        for (std::size_t tile = 0; tile < state.tiles().size(); ++tile) {
            ByteWriter bytes;
            rounds.push_back(state.rounds(tile));
            if (rounds.back() > 0) {
                state.save(tile, bytes);
            }
            tiles.push_back(bytes.bytes());
        }
        splats.put(sums.paths());
        splats.put_all(sums.words());
    }

    std::vector<std::uint32_t> rounds;
    std::vector<std::string> tiles;
    ByteWriter splats;
};

}  // namespace

const std::string& FilmAbout::text(const std::string& key) const {
    static const std::string none;
    const auto found = texts.find(key);
    return found == texts.end() ? none : found->second;
}

const std::vector<std::string>& FilmAbout::list(const std::string& key) const {
    static const std::vector<std::string> none;
    const auto found = lists.find(key);
    return found == lists.end() ? none : found->second;
}

FilmShape shape_of(const FilmState& state) {
    const FilmSums* sums = state.sums();
    return {state.film().width, state.film().height, state.tile_size(), sums != nullptr, sums != nullptr ? sums->layers() : FilmLayers{}};
}

std::uint64_t write_film_file(const std::string& path, const FilmAbout& about, const FilmState& state, const std::string& keep_as,
                              bool durable) {
    ReplacementFile file(path);
    std::uint64_t size = 0;
    const auto write = [&](std::string_view bytes) {
        file.write(bytes);
        size += bytes.size();
    };
    ByteWriter record;
    ByteWriter payload;
    write(signature);
    seal(format_version, 0, encode_head(about, shape_of(state)), record);
    write(record.bytes());
    std::uint32_t count = 0;
    const auto write_tile = [&](std::size_t tile, std::uint32_t rounds, const std::string& bytes) {
        if (rounds > 0) {
            seal(static_cast<std::uint32_t>(tile), rounds, bytes, record);
            write(record.bytes());
            ++count;
        }
    };
    if (const SplatSums* splats = state.sums() != nullptr ? state.sums()->splats() : nullptr) {
        const WholeFilm copy(state, *splats);
        for (std::size_t tile = 0; tile < copy.tiles.size(); ++tile) {
            write_tile(tile, copy.rounds[tile], copy.tiles[tile]);
        }
        seal(splats_mark, 0, copy.splats.bytes(), record);
        write(record.bytes());
    } else {
        for (std::size_t tile = 0; tile < state.tiles().size(); ++tile) {
            payload.clear();
            std::uint32_t rounds = 0;
            {
                const auto lock = state.lock(tile);
                rounds = state.rounds(tile);
                if (rounds > 0) {
                    state.save(tile, payload);
                }
            }
            write_tile(tile, rounds, payload.bytes());
        }
    }
    seal(end_mark, count, "", record);
    write(record.bytes());
    if (durable) {
        file.flush();
    }
    if (!keep_as.empty()) {
        std::rename(path.c_str(), keep_as.c_str());  // there may be none yet
    }
    file.put_in_place();
    return size;
}

FilmFile::FilmFile(const std::string& path) : path_(path) {
    Diagnostics problems;
    std::optional<FileBytes> bytes = read_file(path, {}, problems);
    if (!bytes) {
        throw FilmDamaged(problems.list().front().message);
    }
    bytes_ = std::move(*bytes);
    ByteReader reader(bytes_.view());
    if (reader.take(signature.size()) != signature) {
        throw FilmDamaged(fmt::format("{} is not a film of lancer", path));
    }
    // One sealed record; nothing where it is cut short.
    const auto next = [&]() -> std::optional<Record> {
        const std::string_view all = bytes_.view().substr(bytes_.size - reader.left());
        Record record;
        std::uint64_t size = 0;
        Hash hash{};
        reader.get(record.tile);
        reader.get(record.rounds);
        reader.get(size);
        record.bytes = reader.take(size);
        const std::size_t covered = all.size() - reader.left();
        reader.get(hash);
        if (!reader.good()) {
            return std::nullopt;
        }
        if (hash_bytes(all.substr(0, covered)) != hash) {
            throw FilmDamaged(fmt::format("{} is damaged: a checksum is wrong", path));
        }
        return record;
    };
    const auto cut_short = [&]() -> FilmDamaged { return FilmDamaged(fmt::format("{} is damaged: it was cut short", path)); };
    const std::optional<Record> head = next();
    if (!head) {
        throw cut_short();
    }
    if (head->tile != format_version) {
        throw FilmDamaged(fmt::format("{} was written by another version of lancer", path));
    }
    if (!decode_head(head->bytes, about_, shape_)) {
        throw FilmDamaged(fmt::format("{} is damaged: its head makes no sense", path));
    }
    for (;;) {
        const std::optional<Record> record = next();
        if (!record) {
            throw cut_short();
        }
        if (record->tile == end_mark) {
            if (record->rounds != records_.size() || reader.left() != 0) {
                throw FilmDamaged(fmt::format("{} is damaged: parts are missing", path));
            }
            return;
        }
        if (record->tile == splats_mark) {
            splats_ = record->bytes;
        } else {
            records_.push_back(*record);
        }
    }
}

void FilmFile::add_to(FilmState& state) const {
    std::vector<std::uint32_t> rounds(state.tiles().size(), 0);
    for (const Record& record : records_) {
        if (record.tile >= state.tiles().size()) {
            throw FilmDamaged(fmt::format("{} is damaged: it holds a tile that the picture does not have", path_));
        }
        rounds[record.tile] = record.rounds;
    }
    if (shape_.layers.splats) {
        ByteReader reader(splats_);
        std::uint64_t paths = 0;
        std::vector<SplatSums::Fixed> words(state.sums()->splats()->words().size());
        reader.get(paths);
        reader.get_all(std::span(words));
        if (!reader.good() || reader.left() != 0) {
            throw FilmDamaged(fmt::format("{} is damaged: light that falls anywhere is missing", path_));
        }
        const FilmState::SplatsTaken taken = state.take_splats(words, paths, std::move(rounds));
        if (taken == FilmState::SplatsTaken::mixed) {
            throw FilmDamaged(fmt::format(
                "{} can't be joined with the others: it has more of some parts of the picture and less of others, and light from the lamps "
                "falls from each part on all",
                path_));
        }
        if (taken == FilmState::SplatsTaken::known) {
            return;
        }
    }
    for (const Record& record : records_) {
        ByteReader bytes(record.bytes);
        if (record.rounds > state.rounds(record.tile) && !state.load(record.tile, record.rounds, bytes)) {
            throw FilmDamaged(fmt::format("{} is damaged: a tile makes no sense", path_));
        }
    }
}

}  // namespace lancer
