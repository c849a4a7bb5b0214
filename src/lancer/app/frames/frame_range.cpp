#include "lancer/app/frames/frame_range.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace lancer::app {

namespace {

std::optional<int> read_number(std::string_view digits) {
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool good = error == std::errc() && end == digits.data() + digits.size() && !digits.empty() && digits.front() != '-';
    return good && number <= last_frame ? std::optional(number) : std::nullopt;
}

struct Run {
    std::size_t begin = 0;
    std::size_t size = 0;  // 0: there is none
};

Run number_sign(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    const std::size_t last = path.rfind('#');
    if (last == std::string::npos || last < name) {
        return {};
    }
    std::size_t begin = last;
    while (begin > name && path[begin - 1] == '#') {
        --begin;
    }
    return {begin, last - begin + 1};
}

}  // namespace

std::optional<FrameRange> read_frame_range(const std::string& text) {
    std::vector<int> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(':', begin), text.size());
        const std::optional<int> number = read_number(std::string_view(text).substr(begin, end - begin));
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() == 2) {
        numbers.push_back(1);
    }
    const bool good = numbers.size() == 3 && numbers[0] <= numbers[1] && numbers[2] >= 1;
    return good ? std::optional(FrameRange{numbers[0], numbers[1], numbers[2]}) : std::nullopt;
}

std::string in_words(const FrameRange& range) {
    return range.step == 1 ? fmt::format("{}:{}", range.first, range.last) : fmt::format("{}:{}:{}", range.first, range.last, range.step);
}

double moment_of(int frame, double fps) { return static_cast<double>(frame) / fps; }

bool has_number_sign(const std::string& path) { return number_sign(path).size > 0; }

std::string numbered(const std::string& path, int frame) {
    const Run run = number_sign(path);
    std::string result = path;
    return run.size == 0 ? result : result.replace(run.begin, run.size, fmt::format("{:0{}}", frame, run.size));
}

std::string without_number_sign(const std::string& path) {
    const Run run = number_sign(path);
    if (run.size == 0) {
        return std::filesystem::path(path).replace_extension().string();
    }
    std::string stem = path.substr(0, run.begin);
    while (!stem.empty() && (stem.back() == '.' || stem.back() == '_' || stem.back() == '-')) {
        stem.pop_back();
    }
    return stem.empty() || stem.back() == '/' ? stem + "frames" : stem;
}

std::vector<int> frames_there(const std::string& pattern) {
    const Run run = number_sign(pattern);
    const std::string before = std::filesystem::path(pattern.substr(0, run.begin) + "0").filename().string();
    const std::string_view start = std::string_view(before).substr(0, before.size() - 1);
    const std::string end = pattern.substr(run.begin + run.size);
    const std::filesystem::path parent = std::filesystem::path(pattern).parent_path();
    std::vector<int> frames;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(parent.empty() ? "." : parent, ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.size() <= start.size() + end.size() || !name.starts_with(start) || !name.ends_with(end)) {
            continue;
        }
        const auto number = read_number(std::string_view(name).substr(start.size(), name.size() - start.size() - end.size()));
        if (number && std::filesystem::path(numbered(pattern, *number)).filename() == name) {
            frames.push_back(*number);
        }
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

}  // namespace lancer::app
