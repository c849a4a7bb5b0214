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

std::string to_string(const SourcePosition& position) {
    std::string text = position.file;
    if (!text.empty() && position.line > 0) {
        text += fmt::format(":{}", position.line);
        if (position.column > 0) {
            text += fmt::format(":{}", position.column);
        }
    } else if (!text.empty() && position.byte >= 0) {
        text += fmt::format(": byte {}", position.byte);
    }
    return text;
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string text = to_string(diagnostic.position);
    if (!text.empty()) {
        text += ": ";
    }
    return text + word(diagnostic.severity) + ": " + diagnostic.message;
}

void Diagnostics::note(SourcePosition position, std::string message) { add({Severity::note, std::move(position), std::move(message)}); }

void Diagnostics::warning(SourcePosition position, std::string message) {
    add({Severity::warning, std::move(position), std::move(message)});
}

void Diagnostics::error(SourcePosition position, std::string message) { add({Severity::error, std::move(position), std::move(message)}); }

void Diagnostics::append(Diagnostics&& later) {
    for (Diagnostic& diagnostic : later.list_) {
        add(std::move(diagnostic));
    }
    later.list_.clear();
    later.errors_ = 0;
}

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) {
        ++errors_;
    }
    list_.push_back(std::move(diagnostic));
}

}  // namespace lancer
