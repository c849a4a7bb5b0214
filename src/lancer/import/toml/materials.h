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

    // The names of all [material.NAME] of the file, in its order; what they are is read afterwards.
    void read_names(const toml::table& root);
    void read_named();

    // Those of an included file: the index that each has in this scene. Where this file has a material of that name, it is the one that is meant.
    // The others can be spoken of by their names as well.
    std::vector<int> adopt(std::vector<scene::Material>&& included);

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
    struct Written {
        const toml::key* key;
        const toml::node* node;
    };
    std::vector<Written> in_order_;  // of the file; toml++ sorts by name
    std::vector<bool> used_;         // of the named ones, which come first
    int preset_ = -1;
};

}  // namespace lancer::notation
