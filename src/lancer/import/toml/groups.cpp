#include "lancer/import/toml/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include <glm/geometric.hpp>

namespace lancer::notation {

namespace {

constexpr int deepest = 64;
constexpr std::uint64_t most_objects = 10'000'000;
constexpr double smallest_scale = 1e-12;  // of all placements around an object together

// How much a map shrinks at most; maps here are translate * rotate * scale.
double shrinking(const glm::dmat4& map) {
    return std::min({glm::length(glm::dvec3(map[0])), glm::length(glm::dvec3(map[1])), glm::length(glm::dvec3(map[2]))});
}

struct Member {
    std::string name;
    SourcePosition position;
    Contents contents;
    // Known once everything that it places is in order:
    int index = -1;             // into Scene::groups
    int depth = 1;              // of groups in groups; the whole scene is no group and begins with 0
    std::uint64_t objects = 0;  // with those of its placements, and one for each placement
    double scale = 1.0;         // how much it shrinks something at most
};

class Groups {
public:
    Groups(Context& context, Materials& materials, const std::vector<Included>& included)
        : context_(context), materials_(materials), included_(included) {}

    void run(const toml::table& root) {
        take_included();
        read(root);
        put_in_order();
        whole_.contents = read_contents(context_, materials_, root);
        whole_.depth = 0;
        resolve(whole_);
        if ((!whole_.contents.placements.empty() || !included_.empty()) && sum_up(whole_)) {
            refuse_too_much();
        }
        for (const Included& included : included_) {
            if (included.name.empty()) {
                context_.scene.placements.push_back(included.placement);
            }
        }
        emit(whole_, context_.scene.objects, context_.scene.placements);
        if (context_.messages.diagnostics().has_errors()) {
            return;  // who places what is not certain
        }
        for (const Member& member : members_) {
            if (!member.name.empty() && !used_.contains(member.name)) {
                context_.messages.warning(member.position, fmt::format("group \"{}\" is never placed", member.name));
            }
        }
    }

private:
    void error(const SourcePosition& position, std::string message) { context_.messages.error(position, std::move(message)); }

    // Includes with names are groups that are in order already.
    void take_included() {
        for (const Included& included : included_) {
            if (included.name.empty()) {
                continue;
            }
            Member member;
            member.name = included.name;
            member.position = included.position;
            member.index = included.placement.group;
            member.depth = included.depth;
            member.objects = included.objects;
            if (!by_name_.try_emplace(member.name, members_.size()).second) {
                error(included.position, fmt::format("another include is called \"{}\" already", member.name));
            }
            members_.push_back(std::move(member));
        }
    }

    void read(const toml::table& root) {
        for (const toml::table* table : tables_of(context_.messages, root, group().name)) {
            TableReader reader(context_.messages, *table, group(), {group_sections(), false});
            Member member;
            member.name = reader.text("name");
            member.position = reader.position();
            member.contents = read_contents(context_, materials_, *table);
            if (!member.name.empty() && !by_name_.try_emplace(member.name, members_.size()).second) {
                const SourcePosition& first = members_[by_name_[member.name]].position;
                reader.error("name", fmt::format("a group \"{}\" was defined in line {} already", member.name, first.line));
            }
            members_.push_back(std::move(member));
        }
    }

    // Replaces names by numbers of members; placements of unknown groups go.
    void resolve(Member& member) {
        std::erase_if(member.contents.placements, [&](NamedPlacement& named) {
            if (named.group.empty()) {
                return true;  // said already
            }
            const auto found = by_name_.find(named.group);
            if (found == by_name_.end()) {
                complain_about_unknown(named);
                return true;
            }
            used_[named.group] = true;
            named.placement.group = static_cast<int>(found->second);
            return false;
        });
    }

    void complain_about_unknown(const NamedPlacement& named) {
        if (context_.messages.full()) {
            return;
        }
        std::vector<std::string> names;
        for (const auto& [name, index] : by_name_) {
            names.push_back(name);
        }
        const std::string hint = did_you_mean(named.group, names);
        const std::string expected = names.empty() ? "; there are no groups" : "; there are " + some_of(names);
        error(named.group_position, fmt::format("there is no group \"{}\"{}", named.group, hint.empty() ? expected : ";" + hint));
    }

    // A group follows when all that it places have come [Kahn 1962]. No recursion: chains may be long.
    void put_in_order() {
        std::vector<std::vector<std::size_t>> placed_by(members_.size());
        std::vector<std::size_t> waits_for(members_.size());
        for (std::size_t i = 0; i < members_.size(); ++i) {
            resolve(members_[i]);
            waits_for[i] = members_[i].contents.placements.size();
            for (const NamedPlacement& named : members_[i].contents.placements) {
                placed_by[static_cast<std::size_t>(named.placement.group)].push_back(i);
            }
        }
        std::vector<std::size_t> ready;
        for (std::size_t i = 0; i < members_.size(); ++i) {
            if (waits_for[i] == 0) {
                ready.push_back(i);
            }
        }
        for (std::size_t next = 0; next < ready.size(); ++next) {
            Member& member = members_[ready[next]];
            if (member.index < 0) {
                if (!sum_up(member)) {
                    too_much_said_ = true;
                }
                member.index = static_cast<int>(context_.scene.groups.size());
                scene::Group& group = context_.scene.groups.emplace_back();
                group.name = member.name;
                emit(member, group.objects, group.placements);
            }
            for (std::size_t user : placed_by[ready[next]]) {
                if (--waits_for[user] == 0) {
                    ready.push_back(user);
                }
            }
        }
        complain_about_circles();
    }

    // What is left waits for itself: follow one placement after another until a group comes again.
    void complain_about_circles() {
        std::vector<bool> seen(members_.size(), false);
        for (std::size_t start = 0; start < members_.size(); ++start) {
            std::vector<std::size_t> path;
            std::size_t at = start;
            while (members_[at].index < 0 && !seen[at]) {
                seen[at] = true;
                path.push_back(at);
                at = static_cast<std::size_t>(waiting_placement(members_[at])->placement.group);
            }
            const auto circle = std::find(path.begin(), path.end(), at);
            if (circle == path.end()) {
                continue;
            }
            std::string names;
            for (auto i = circle; i != path.end() && i - circle < 8; ++i) {
                names += fmt::format("\"{}\" places ", members_[*i].name);
            }
            names += path.end() - circle > 8 ? "... " : "";
            error(waiting_placement(members_[path.back()])->group_position,
                  fmt::format("a group can't be inside itself: {}\"{}\"", names, members_[at].name));
        }
    }

    // The first placement of a group that is in no order yet.
    const NamedPlacement* waiting_placement(const Member& member) const {
        for (const NamedPlacement& named : member.contents.placements) {
            if (members_[static_cast<std::size_t>(named.placement.group)].index < 0) {
                return &named;
            }
        }
        return nullptr;
    }

    // Depth, number and size of everything inside; false after an error.
    bool sum_up(Member& member) {
        const int own_level = member.depth;
        member.objects = member.contents.objects.size();
        for (const scene::Object& object : member.contents.objects) {
            member.scale = std::min(member.scale, shrinking(object.to_parent));
        }
        for (const NamedPlacement& named : member.contents.placements) {
            const Member& inside = members_[static_cast<std::size_t>(named.placement.group)];
            member.depth = std::max(member.depth, inside.depth + own_level);
            member.objects = std::min(member.objects + inside.objects + 1, 2 * most_objects);
            member.scale = std::min(member.scale, shrinking(named.placement.to_parent) * inside.scale);
            if (too_much_said_) {
                continue;
            }
            if (member.depth > deepest) {
                error(named.group_position, fmt::format("groups are nested too deep: at most {} inside each other", deepest));
                return false;
            }
            if (member.scale < smallest_scale) {
                error(named.placement.position,
                      fmt::format("what this places is scaled by {:.3g} in all: nothing would be left", member.scale));
                return false;
            }
        }
        return true;
    }

    void refuse_too_much() {
        std::uint64_t objects = whole_.objects;
        for (const Included& included : included_) {
            objects += included.name.empty() ? included.objects : 0;
        }
        if (objects > most_objects) {
            error(whole_.contents.placements.empty() ? included_.front().position : whole_.contents.placements.front().placement.position,
                  fmt::format("the placements make more than {} objects", most_objects));
        }
    }

    void emit(Member& member, std::vector<scene::Object>& objects, std::vector<scene::Placement>& placements) {
        std::move(member.contents.objects.begin(), member.contents.objects.end(), std::back_inserter(objects));
        for (const NamedPlacement& named : member.contents.placements) {
            const Member& inside = members_[static_cast<std::size_t>(named.placement.group)];
            if (inside.index >= 0) {
                placements.push_back(named.placement);
                placements.back().group = inside.index;
            }
        }
    }

    Context& context_;
    Materials& materials_;
    const std::vector<Included>& included_;
    std::vector<Member> members_;
    std::map<std::string, std::size_t> by_name_;
    std::map<std::string, bool> used_;
    Member whole_;
    bool too_much_said_ = false;  // once is enough: everything around it is too much as well
};

}  // namespace

void read_groups_and_contents(Context& context, Materials& materials, const std::vector<Included>& included, const toml::table& root) {
    Groups(context, materials, included).run(root);
}

}  // namespace lancer::notation
