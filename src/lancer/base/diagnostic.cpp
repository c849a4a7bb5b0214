#include "lancer/base/diagnostic.h"

#include <fmt/format.h>

namespace lancer {

namespace {

const char* word(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::error:
            break;
    }
    return "error";
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
    const SourcePosition& at = diagnostic.position;
    std::string text = at.file;
    if (!at.file.empty() && at.line > 0) {
        text += fmt::format(":{}", at.line);
        if (at.column > 0) {
            text += fmt::format(":{}", at.column);
        }
    }
    if (!text.empty()) {
        text += ": ";
    }
    return text + word(diagnostic.severity) + ": " + diagnostic.message;
}

void Diagnostics::note(SourcePosition position, std::string message) { add(Severity::note, std::move(position), std::move(message)); }

void Diagnostics::warning(SourcePosition position, std::string message) { add(Severity::warning, std::move(position), std::move(message)); }

void Diagnostics::error(SourcePosition position, std::string message) { add(Severity::error, std::move(position), std::move(message)); }

void Diagnostics::add(Severity severity, SourcePosition position, std::string message) {
    if (severity == Severity::error) {
        ++errors_;
    }
    list_.push_back({severity, std::move(position), std::move(message)});
}

}  // namespace lancer
