#include "lancer/import/mitsuba/document.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "lancer/import/mitsuba/plugin.h"
#include "lancer/import/mitsuba/xml.h"

namespace lancer::mitsuba {

namespace {

namespace fs = std::filesystem;

constexpr int deepest = 100;
constexpr std::size_t most_elements = 4'000'000;
constexpr int most_includes = 1000;
constexpr std::size_t largest_value = std::size_t{64} << 20;

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

std::string below(const std::string& folder, const std::string& name) { return (fs::path(folder) / name).lexically_normal().string(); }

bool exists(const std::string& path) {
    std::error_code problem;
    return fs::exists(path, problem);
}

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// "toWorld" and "intIOR" are "to_world" and "int_ior" since version 2.
std::string with_underscores(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        if (std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0) {
            result += '_';
        }
        result += static_cast<char>(std::tolower(c));
    }
    return result;
}

}  // namespace

Document::Document(ImportContext& context) : context_(context), parameters_(context.options.defines) {}

void Document::fail(const SourcePosition& position, std::string message) {
    failed_ = true;
    context_.diagnostics.error(position, std::move(message));
}

std::optional<Element> Document::read() {
    Element scene;
    scene.tag = "scene";
    scene.position = {context_.path, 1, 1};
    if (!read_file(context_.path, {}, scene) || failed_) {
        return std::nullopt;
    }
    return scene;
}

std::string Document::resolve(const std::string& name, const SourcePosition& named_at) const {
    if (fs::path(name).is_absolute()) {
        return name;
    }
    const std::string beside_scene = below(folder_of(context_.path), name);
    if (exists(beside_scene)) {
        return beside_scene;
    }
    for (const std::string& folder : folders_) {
        if (const std::string path = below(folder, name); exists(path)) {
            return path;
        }
    }
    if (const std::string beside_file = below(folder_of(named_at.file), name); exists(beside_file)) {
        return beside_file;
    }
    return find_above(name, named_at).value_or(beside_scene);
}

// Fragments are meant to be included from folders above, and large collections keep what several scenes use in a folder "common" further up.
std::optional<std::string> Document::find_above(const std::string& name, const SourcePosition& named_at) const {
    constexpr int levels = 5;
    std::error_code problem;
    fs::path folder = fs::absolute(folder_of(named_at.file), problem);
    for (int level = 0; level < levels && folder.has_parent_path(); ++level) {
        folder = folder.parent_path();
        for (const char* part : {".", "common"}) {
            const std::string path = below((folder / part).string(), name);
            if (exists(path)) {
                context_.diagnostics.warning(named_at, fmt::format("\"{}\" is not here; \"{}\" is read", name, path));
                return path;
            }
        }
    }
    return std::nullopt;
}

bool Document::read_file(const std::string& path, const SourcePosition& named_at, Element& parent) {
    if (std::find(open_.begin(), open_.end(), path) != open_.end()) {
        fail(named_at, fmt::format("\"{}\" includes itself", path));
        return false;
    }
    const auto bytes = context_.files.open(path, named_at);
    const auto xml = bytes ? Xml::parse(bytes->view(), path, context_.diagnostics) : std::nullopt;
    if (!xml) {
        failed_ = true;
        return false;
    }
    if (std::string_view(xml->root().name()) != "scene") {
        fail(xml->position(xml->root()), fmt::format("expected <scene>, found <{}>", xml->root().name()));
        return false;
    }
    const bool old = old_;
    const int version = xml->root().attribute("version") ? std::atoi(xml->root().attribute("version").value()) : 3;
    old_ = version < 2;
    if (open_.empty()) {
        major_version_ = version;
        parent.position = xml->position(xml->root());
    }
    open_.push_back(path);
    add_children(*xml, xml->root(), parent, static_cast<int>(open_.size()));
    open_.pop_back();
    old_ = old;
    return true;
}

void Document::add_children(const Xml& xml, const pugi::xml_node& node, Element& parent, int depth) {
    for (const pugi::xml_node& child : node.children()) {
        if (failed_) {
            return;
        }
        if (child.type() != pugi::node_element) {
            continue;
        }
        Element element;
        element.tag = child.name();
        element.position = xml.position(child);
        if (depth > deepest || ++elements_ > most_elements) {
            fail(element.position, depth > deepest ? "elements are nested too deeply" : "the scene has far too many elements");
            return;
        }
        for (const pugi::xml_attribute& attribute : child.attributes()) {
            element.attributes.emplace_back(attribute.name(), substitute(attribute.value(), element.position));
        }
        modernise(element);
        if (element.tag == "default") {
            set_default(element);
        } else if (element.tag == "path") {
            add_folder(element);
        } else if (element.tag == "include") {
            include(element, parent);
        } else {
            add_children(xml, child, element, depth + 1);
            parent.children.push_back(std::move(element));
        }
    }
}

void Document::modernise(Element& element) const {
    if (!old_) {
        return;
    }
    element.tag = element.tag == "lookAt" ? "lookat" : element.tag;
    for (auto& [key, value] : element.attributes) {
        if (key == "name") {
            value = with_underscores(value);
        }
    }
}

void Document::set_default(const Element& element) {
    if (!element.find("name") || !element.find("value")) {
        fail(element.position, "<default> needs a \"name\" and a \"value\"");
        return;
    }
    parameters_.try_emplace(element.attribute("name"), element.attribute("value"));
}

void Document::add_folder(const Element& element) {
    const std::string& value = element.attribute("value");
    const std::string folder = fs::path(value).is_absolute() ? value : below(folder_of(element.position.file), value);
    if (!exists(folder)) {
        context_.diagnostics.warning(element.position, fmt::format("there is no folder \"{}\"", folder));
    }
    folders_.insert(folders_.begin(), folder);
}

void Document::include(const Element& element, Element& parent) {
    if (++includes_ > most_includes) {
        fail(element.position, "the scene includes far too many files");
        return;
    }
    read_file(resolve(element.attribute("filename"), element.position), element.position, parent);
}

// "$name" stands for a parameter's value; names reach as far as letters, digits and underscores do, or are in braces. Values are not searched again.
std::string Document::substitute(std::string_view text, const SourcePosition& position) {
    if (text.find('$') == std::string_view::npos) {
        return std::string(text);
    }
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] != '$') {
            result += text[i++];
            continue;
        }
        const bool braces = i + 1 < text.size() && text[i + 1] == '{';
        const std::size_t begin = i + (braces ? 2 : 1);
        std::size_t end = begin;
        while (end < text.size() && is_name(text[end])) {
            ++end;
        }
        const std::string name(text.substr(begin, end - begin));
        const auto found = parameters_.find(name);
        if (name.empty() || found == parameters_.end()) {
            std::vector<std::string> known;
            for (const auto& parameter : parameters_) {
                known.push_back(parameter.first);
            }
            fail(position, fmt::format("the parameter \"${}\" has no value: give it one with -D {}=VALUE{}", name,
                                       name.empty() ? "NAME" : name, hint(name, known)));
            return result;
        }
        result += found->second;
        if (result.size() > largest_value) {
            fail(position, "a value is far too long");
            return {};
        }
        i = end + (braces && end < text.size() && text[end] == '}' ? 1 : 0);
    }
    return result;
}

}  // namespace lancer::mitsuba
