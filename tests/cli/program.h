// Starts the built program as a person would, in a folder of its own, and tells what it said.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace lancer::test {

struct Finished {
    int status = 0;  // the exit status, or minus the signal that ended it
    std::string out;
    std::string err;
};

// An empty folder that is removed with everything in it.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    std::vector<std::string> names() const;  // sorted

private:
    std::filesystem::path path_;
};

using Environment = std::vector<std::pair<std::string, std::string>>;  // an empty value removes the variable

// A program that runs. It is killed when this is destroyed, and after a minute of waiting.
class Running {
public:
    Running(const Folder& folder, const std::vector<std::string>& words, const Environment& environment = {});
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void signal(int number) const;
    bool is_alive();
    Finished wait();

private:
    bool collect(bool block);

    Folder output_;
    pid_t pid_ = -1;
    bool ended_ = false;
    int status_ = 0;
};

// `lancer WORDS...` in `folder`, without a display unless `environment` names one.
Finished run_lancer(const Folder& folder, const std::vector<std::string>& words, const Environment& environment = {});

// A scene that is quick to render, and where the repository keeps its own.
extern const char* const small_scene;
std::string scene_file(const std::string& name);  // "report/figure-1.toml"

}  // namespace lancer::test
