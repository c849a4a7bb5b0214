// Films as files: checkpoints, shares of a picture, and finished films that may get more samples later.
//
// A file is a head (what the film is of), then a record for each tile that has any work behind it, then the splats where there are any, then an end.
// Head, records and end carry a checksum each, so a file that was cut short or damaged is known for it. Numbers are little-endian; doubles are kept as
// they are.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "lancer/base/file.h"
#include "lancer/film/film_state.h"
#include "lancer/image/image.h"

namespace lancer {

// Whatever whoever goes on with the film has to know.
struct FilmAbout {
    Metadata texts;
    std::map<std::string, std::vector<std::string>> lists;

    // Empty where there is none.
    const std::string& text(const std::string& key) const;
    const std::vector<std::string>& list(const std::string& key) const;
};

struct FilmShape {
    int width = 0;
    int height = 0;
    int tile_size = 0;
    bool sums = false;  // of samples: path integrator
    FilmLayers layers;

    bool operator==(const FilmShape&) const = default;
};
FilmShape shape_of(const FilmState& state);

// The file is not a film, cut short, damaged, or of another version of lancer. The sentence names it.
class FilmDamaged : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Writes beside `path` and renames; what stood there becomes `keep_as` if that is not empty. Takes the lock of one tile at a time, so others may
// work on the film meanwhile; where there are splats it holds them off until all has been copied. `durable`: waits for the disk. Returns the number of bytes. Throws MachineFailure.
std::uint64_t write_film_file(const std::string& path, const FilmAbout& about, const FilmState& state, const std::string& keep_as = "",
                              bool durable = false);

class FilmFile {
public:
    // Reads all of it and looks at every checksum. Throws FilmDamaged; MachineFailure where it can't be read at all.
    explicit FilmFile(const std::string& path);

    const std::string& path() const { return path_; }
    const FilmAbout& about() const { return about_; }
    const FilmShape& shape() const { return shape_; }

    // Puts the tiles into the state, which must have the file's shape, where it has more rounds behind them. Throws FilmDamaged, also where splats can't
    // be joined. Who is done with adding has the state show its splats.
    void add_to(FilmState& state) const;

private:
    struct Record {
        std::uint32_t tile = 0;
        std::uint32_t rounds = 0;
        std::string_view bytes;
    };

    std::string path_;
    FileBytes bytes_;
    FilmAbout about_;
    FilmShape shape_;
    std::vector<Record> records_;
    std::string_view splats_;
};

}  // namespace lancer
