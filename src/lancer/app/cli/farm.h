// lancer farm and its parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/farm/farm_job.h"

namespace lancer::app {

void add_farm(CLI::App& program, Work& work);
void add_farm_submit(CLI::App& farm, Work& work);
void add_farm_status(CLI::App& farm, Work& work);

// The job in `folder`; nothing where there is none, which is said.
std::optional<FarmJob> find_farm_job(const CLI::App& app, const std::string& folder);

// Up to ten of them, in words.
std::string list_units(const FarmJob& job, const std::vector<int>& units);

}  // namespace lancer::app
