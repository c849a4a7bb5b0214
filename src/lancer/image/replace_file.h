// Whole files, written so that a reader sees either the old one or the new one.
#pragma once

#include <string>
#include <string_view>

namespace lancer {

// A temporary file in the folder of `path`, removed again unless it is put in place. All functions throw MachineFailure with the path and the
// reason (no such folder, disk full, read-only, ...); what stood at `path` is untouched then.
class ReplacementFile {
public:
    explicit ReplacementFile(const std::string& path);
    ~ReplacementFile();
    ReplacementFile(const ReplacementFile&) = delete;
    ReplacementFile& operator=(const ReplacementFile&) = delete;

    void write(std::string_view bytes);
    // Has the disk take what was written, so that it outlives a machine that loses its power.
    void flush();
    // Ends the file and renames it to `path`.
    void put_in_place();

private:
    std::string path_;
    std::string name_;
    int descriptor_ = -1;
    bool in_place_ = false;
};

// Removes what processes of this machine that were killed have left half written in the folder of `path`. What is being written stays.
void remove_leftovers(const std::string& path);

// Writes `bytes` to a temporary file in the folder of `path` and renames it to `path`. Throws as above.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace lancer
