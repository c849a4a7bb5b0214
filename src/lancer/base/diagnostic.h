// Messages about what the user wrote: where, what is wrong, what was expected. Readers collect many instead of stopping at the first.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lancer {

// A place in a file. Lines and columns count from 1, 0 means unknown; in binary files `byte` counts from 0, -1 means unknown. An empty file name
// means the command line.
struct SourcePosition {
    std::string file;
    int line = 0;
    int column = 0;
    std::int64_t byte = -1;
};

// "file:line:column" or "file: byte 1234"; unknown parts are left out.
std::string to_string(const SourcePosition& position);

enum class Severity { note, warning, error };

struct Diagnostic {
    Severity severity = Severity::error;
    SourcePosition position;
    std::string message;
};

// "file:line:column: error: message", the form that editors understand; unknown parts are left out.
std::string to_string(const Diagnostic& diagnostic);

class Diagnostics {
public:
    void note(SourcePosition position, std::string message);
    void warning(SourcePosition position, std::string message);
    void error(SourcePosition position, std::string message);

    void add(Diagnostic diagnostic);
    void append(Diagnostics&& later);

    bool has_errors() const { return errors_ > 0; }
    const std::vector<Diagnostic>& list() const { return list_; }

private:
    std::vector<Diagnostic> list_;
    int errors_ = 0;
};

// "did you mean "radius"?" with a leading space, or nothing when no candidate is near `word`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace lancer
