#include "lancer/image/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lancer/image/exact.h"

namespace lancer {
namespace {

using Names = std::vector<std::string>;

// Names in all of the runs, of channels that hold measures and not numbers of things.
Names common_channels(const Runs& runs) {
    Names names;
    for (const Channel& channel : runs.images.front().channels) {
        const bool everywhere = std::all_of(runs.images.begin(), runs.images.end(), [&](const LayeredImage& image) {
            const Channel* found = find_channel(image, channel.name);
            return found && found->stored != Stored::uint32;
        });
        if (everywhere) {
            names.push_back(channel.name);
        }
    }
    return names;
}

bool has(const Names& names, const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); }

bool has_all(const Names& names, const Names& wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return has(names, name); });
}

// The picture among the channels: its colours, or its grey, or its spectrum [Fichet et al. 2021], or else everything but the noise.
Names colors_of(const Names& names) {
    if (has_all(names, {"R", "G", "B"})) {
        return {"R", "G", "B"};
    }
    if (has(names, "Y")) {
        return {"Y"};
    }
    Names spectrum, measures;
    for (const std::string& name : names) {
        if (name.starts_with("S0.")) {
            spectrum.push_back(name);
        } else if (!name.starts_with("variance.") && name != "samples") {
            measures.push_back(name);
        }
    }
    return !spectrum.empty() ? spectrum : !measures.empty() ? measures : names;
}

std::vector<float> mean_of_runs(const Runs& runs, const std::string& name) {
    const std::vector<float>& first = find_channel(runs.images.front(), name)->values;
    if (runs.images.size() == 1) {
        return first;
    }
    std::vector<double> sums(first.size(), 0.0);
    for (const LayeredImage& image : runs.images) {
        const std::vector<float>& values = find_channel(image, name)->values;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += static_cast<double>(values[i]);
        }
    }
    std::vector<float> means(first.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        means[i] = static_cast<float>(sums[i] / static_cast<double>(runs.images.size()));
    }
    return means;
}

Image interleaved(const std::vector<std::vector<float>>& planes, int width, int height) {
    Image image{width, height, 3, std::vector<float>(planes.front().size() * 3)};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float>& plane = planes[std::min(c, planes.size() - 1)];
        for (std::size_t i = 0; i < plane.size(); ++i) {
            image.pixels[3 * i + c] = plane[i];
        }
    }
    return image;
}

double encoded_mse(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto shown = [](float v) { return static_cast<double>(srgb_encode(v > 0.0f ? std::min(v, 1.0f) : 0.0f)); };
        const double d = shown(a.pixels[i]) - shown(b.pixels[i]);
        sum += d * d;
    }
    return sum / static_cast<double>(a.pixels.size());
}

double step_of(const Channel& channel, bool display) { return channel.stored == Stored::half ? 0x1p-10 : display ? 0x1p-7 : 0x1p-23; }

NoisyChannel noisy_channel(const Runs& runs, const std::string& name) {
    NoisyChannel result;
    for (const LayeredImage& image : runs.images) {
        const Channel* channel = find_channel(image, name);
        result.runs.emplace_back(channel->values);
        result.rounding = step_of(*channel, image.display);
    }
    if (runs.images.size() == 1) {
        const LayeredImage& image = runs.images.front();
        if (const Channel* variance = find_channel(image, "variance." + name)) {
            result.variances = variance->values;
        }
        if (const Channel* samples = find_channel(image, "samples")) {
            result.samples = samples->values;
        }
    }
    return result;
}

// The luminance of each run [IEC 61966-2-1]. Of the colours' variances but not their correlation nothing sharper is known than
// standard deviations that add up: the noise of luminance is never stated too small.
struct Luminance {
    std::vector<std::vector<float>> runs;
    std::vector<float> variances;
    NoisyChannel channel;

    explicit Luminance(const Runs& of) {
        constexpr float weights[] = {0.2126f, 0.7152f, 0.0722f};
        const Names names = {"R", "G", "B"};
        const NoisyChannel first = noisy_channel(of, "R");
        for (const LayeredImage& image : of.images) {
            std::vector<float>& run = runs.emplace_back(first.runs.front().size(), 0.0f);
            for (std::size_t c = 0; c < 3; ++c) {
                const std::vector<float>& values = find_channel(image, names[c])->values;
                for (std::size_t i = 0; i < run.size(); ++i) {
                    run[i] += weights[c] * values[i];
                }
            }
        }
        channel = first;
        channel.variances = {};
        channel.runs.assign(runs.begin(), runs.end());
        if (has_variances(of)) {
            variances.assign(runs.front().size(), 0.0f);
            for (std::size_t c = 0; c < 3; ++c) {
                const std::vector<float>& of_color = find_channel(of.images.front(), "variance." + names[c])->values;
                for (std::size_t i = 0; i < variances.size(); ++i) {
                    variances[i] += weights[c] * std::sqrt(std::max(0.0f, of_color[i]));
                }
            }
            for (float& deviation : variances) {
                deviation *= deviation;
            }
            channel.variances = variances;
        }
    }
    Luminance(const Luminance&) = delete;
    Luminance& operator=(const Luminance&) = delete;

    static bool has_variances(const Runs& runs) {
        const Names names = common_channels(runs);
        return runs.images.size() == 1 && has_all(names, {"variance.R", "variance.G", "variance.B"});
    }
};

BiasTest test_means(const std::string& name, const NoisyChannel& a, const NoisyChannel& b, int width, int height) {
    std::vector<bool> skip(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (const NoisyChannel* channel : {&a, &b}) {
        for (std::size_t i = 0; i < skip.size(); ++i) {
            skip[i] = skip[i] || !is_finite(*channel, i);
        }
    }
    std::uint64_t count = 0;
    const Rectangle whole{0, 0, width, height};
    const Measured reference = measure(b, width, whole, skip, count);
    return {name, reference.mean, welch_test(measure(a, width, whole, skip, count), reference), {}, {}};
}

void test_bias(const Runs& picture, const Runs& reference, const ComparisonOptions& options, Comparison& result) {
    const auto is_exact = [&](const Runs& runs) {
        return std::all_of(result.colors.begin(), result.colors.end(),
                           [&](const ChannelComparison& color) { return noisy_channel(runs, color.name).is_exact(); });
    };
    result.picture_is_exact = is_exact(picture);
    result.reference_is_exact = is_exact(reference);
    if (result.colors.size() == 3 && result.colors.front().name == "R") {
        const Luminance a(picture), b(reference);
        if (!a.channel.is_exact() || !b.channel.is_exact()) {
            result.bias.push_back(test_means("luminance", a.channel, b.channel, result.width, result.height));
            result.headline_p = result.bias.front().means.p;
        }
    }
    const double channels = static_cast<double>(result.colors.size());
    double smallest_block_p = 2.0;
    for (const ChannelComparison& color : result.colors) {
        const NoisyChannel a = noisy_channel(picture, color.name), b = noisy_channel(reference, color.name);
        if (a.is_exact() && b.is_exact()) {
            continue;  // nothing is known of its noise
        }
        BiasTest test = test_means(color.name, a, b, result.width, result.height);
        test.pixels = test_cells(a, b, result.width, result.height, 1);
        test.blocks = test_cells(a, b, result.width, result.height, options.block);
        const double p = std::min(1.0, test.means.p * channels);
        if (result.bias.empty() || (result.headline_p >= options.significance && p < std::min(result.headline_p, options.significance))) {
            result.headline = result.bias.size();
            result.headline_p = p;
        }
        if (test.blocks->worst_p < smallest_block_p) {
            smallest_block_p = test.blocks->worst_p;
            result.worst_block = result.bias.size();
        }
        result.bias.push_back(std::move(test));
    }
    result.worst_block_p = std::min(1.0, smallest_block_p * channels);
}

std::string p_in_words(double p) { return p < 1e-12 ? "p < 1e-12" : fmt::format("p = {:.2g}", p); }

}  // namespace

Runs Runs::read(const std::vector<std::string>& paths) {
    Runs runs;
    for (const std::string& path : paths) {
        runs.names.push_back(path);
        runs.images.push_back(read_layers(path));
        check_same_size(runs.images.front(), paths.front(), runs.images.back(), path);
    }
    return runs;
}

Comparison compare(const Runs& picture, const Runs& reference, const ComparisonOptions& options) {
    const LayeredImage &a = picture.images.front(), &b = reference.images.front();
    check_same_size(a, picture.names.front(), b, reference.names.front());
    Names both;
    const Names of_reference = common_channels(reference);
    for (const std::string& name : common_channels(picture)) {
        if (has(of_reference, name)) {
            both.push_back(name);
        }
    }
    if (both.empty()) {
        const auto names = [](const LayeredImage& image) {
            Names result;
            for (const Channel& channel : image.channels) {
                result.push_back(channel.name);
            }
            return fmt::format("{}", fmt::join(result, ", "));
        };
        throw std::runtime_error(fmt::format("no channel is in both pictures: {} has {}; {} has {}", picture.names.front(), names(a),
                                             reference.names.front(), names(b)));
    }
    Comparison result;
    result.width = a.width;
    result.height = a.height;
    const auto is_display = [](const LayeredImage& image) { return image.display; };
    result.display = std::any_of(picture.images.begin(), picture.images.end(), is_display) ||
                     std::any_of(reference.images.begin(), reference.images.end(), is_display);

    const Names colors = colors_of(both);
    std::vector<std::vector<float>> planes, reference_planes;
    std::vector<ChannelErrors> errors;
    for (const std::string& name : colors) {
        planes.push_back(mean_of_runs(picture, name));
        reference_planes.push_back(mean_of_runs(reference, name));
        errors.push_back(channel_errors(planes.back(), reference_planes.back()));
        result.colors.push_back({name, errors.back()});
    }
    result.all = joined(errors);
    if (colors.front() == "R" || colors.front() == "Y") {
        result.mean = interleaved(planes, a.width, a.height);
        result.reference_mean = interleaved(reference_planes, a.width, a.height);
        if (result.display) {
            result.flip = flip_for_displays(result.mean, result.reference_mean, options.pixels_per_degree);
            result.psnr = peak_signal_to_noise(encoded_mse(result.mean, result.reference_mean), 1.0);
        } else {
            result.exposures = flip_exposures(result.reference_mean);
            result.flip = flip_for_light(result.mean, result.reference_mean, *result.exposures, options.pixels_per_degree);
        }
    }
    for (const std::string& name : both) {
        if (has(colors, name)) {
            continue;
        }
        ++result.more_channels;
        if (options.others) {
            result.others.push_back({name, channel_errors(mean_of_runs(picture, name), mean_of_runs(reference, name))});
        }
    }
    test_bias(picture, reference, options, result);
    return result;
}

std::string verdict(const Comparison& comparison, const ComparisonOptions& options) {
    if (comparison.bias.empty()) {
        return "whether the means differ can't be told, for nothing is known of the noise";
    }
    const BiasTest& test = comparison.bias[comparison.headline];
    const double unit = test.reference_mean != 0.0 ? 0.01 * std::fabs(test.reference_mean) : 1.0;
    const char* percent = test.reference_mean != 0.0 ? " %" : "";
    // As many digits as the error has two of.
    const double error = test.means.error / unit, difference = test.means.difference / unit;
    const double smallest = error > 0.0 ? error : std::fabs(difference);
    const int digits = smallest > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(smallest))), 0, 9) : 0;
    const bool differ = comparison.headline_p < options.significance;
    const std::string of = test.name == "luminance" || comparison.bias.size() == 1 ? "" : fmt::format(" of {}", test.name);
    std::string sentence =
        fmt::format("the means{} {} by {:+.{}f}{} +- {:.{}f}{} ({})", of, differ ? "differ" : "differ no more than noise does,", difference,
                    digits, percent, error, digits, percent, p_in_words(comparison.headline_p));
    const CellTests& blocks = *comparison.bias[comparison.worst_block].blocks;
    if (comparison.worst_block_p < options.significance) {
        sentence += fmt::format("{} some blocks of {} x {} pixels do, most of all {} at {},{} ({})", differ ? ", and" : ", but",
                                blocks.side, blocks.side, comparison.bias[comparison.worst_block].name, blocks.worst_x, blocks.worst_y,
                                p_in_words(comparison.worst_block_p));
    }
    return sentence;
}

}  // namespace lancer
