// Materials, by name and in place.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

class Materials {
public:
    explicit Materials(Context& context) : context_(context) {}

    // All [material.NAME] of the file, in its order.
    void read_named(const toml::table& root);

    // The value of a key `material`: an index into Scene::materials; -1 when the key is not written or wrong.
    int read(TableReader& reader, std::string_view key);

    // For shapes without a material; made when it is asked for.
    int preset();

    void warn_about_unused();

private:
    scene::Material read_table(const toml::table& table);
    scene::MixMaterial read_mix(TableReader& reader);
    void read_sides(TableReader& reader, scene::Material& material);

    Context& context_;
    std::map<std::string, int, std::less<>> by_name_;
    std::vector<bool> used_;  // of the named ones, which come first
    int preset_ = -1;
};

}  // namespace lancer::notation
