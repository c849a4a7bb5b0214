// The frames of an animation: which, when, and how their files are called.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lancer::app {

// FIRST:LAST or FIRST:LAST:STEP. Both ends count, as film people count; the last is left out where no step lands on it.
struct FrameRange {
    int first = 0;
    int last = 0;
    int step = 1;

    int count() const { return (last - first) / step + 1; }
    int number(int index) const { return first + index * step; }
};

constexpr int last_frame = 9'999'999;
constexpr double usual_fps = 24.0;

// Nothing where the text is no such range: whole numbers from 0 to `last_frame`, FIRST <= LAST, STEP >= 1.
std::optional<FrameRange> read_frame_range(const std::string& text);
std::string in_words(const FrameRange& range);  // as it is read

// The moment of a frame in seconds: frame 0 is the beginning.
double moment_of(int frame, double fps);

// The last run of # in the file's name (not in its folders) stands for the frame's number, with zeros in front as far as the run reaches.
bool has_number_sign(const std::string& path);
std::string numbered(const std::string& path, int frame);
std::string without_number_sign(const std::string& path);  // "a/frame.####.exr" to "a/frame"; other names lose their ending only

// The frames whose files are there, in order. Names in which the number has another width than `pattern` asks for are no frames.
std::vector<int> frames_there(const std::string& pattern);

}  // namespace lancer::app
