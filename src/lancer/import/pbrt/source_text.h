// The text of one file. What is found in it is kept as parts of it, so that every part knows its place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/base/file.h"

namespace lancer::pbrt {

class SourceText {
public:
    SourceText(std::string path, FileBytes bytes) : path_(std::move(path)), bytes_(std::move(bytes)) {}
    SourceText(const SourceText&) = delete;
    SourceText& operator=(const SourceText&) = delete;

    const std::string& path() const { return path_; }
    std::string_view view() const { return bytes_.view(); }

    // Where a part of this text begins. The first call counts the lines: not for several threads.
    SourcePosition position(std::string_view part) const;

private:
    std::string path_;
    FileBytes bytes_;
    mutable std::vector<std::size_t> line_begins_;
};

}  // namespace lancer::pbrt
