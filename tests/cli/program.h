// Starts the built program as a person would, in a folder of its own, and tells what it said.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "temporary_folder.h"

namespace lancer::test {

struct Finished {
    int status = 0;  // the exit status, or minus the signal that ended it
    std::string out;
    std::string err;
};

using Folder = tests::TemporaryFolder;

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
