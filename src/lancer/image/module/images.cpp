// The module: OpenImageIO behind plain functions. No exception leaves it.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/image/module/interface.h"

namespace {

namespace oiio = OIIO;

void say(void* receiver, LancerSink sink, std::string_view words) { sink(receiver, words.data(), words.size()); }

// What OpenImageIO says, in one line and without the path, which the caller knows better.
std::string plain(std::string message, std::string_view path, const char* otherwise) {
    message = message.substr(0, message.find('\n'));
    std::string quoted(1, '"');
    quoted.append(path).append(1, '"');
    std::string bracketed(" (");
    bracketed.append(quoted).append(1, ')');
    for (const std::string& named : {bracketed, quoted}) {
        if (const std::size_t at = message.find(named); !path.empty() && at != std::string::npos) {
            message.erase(at, named.size());
        }
    }
    return message.empty() ? otherwise : message;
}

struct Reader {
    std::unique_ptr<oiio::ImageInput> input;
    std::string path;
    std::vector<int> channels;  // of the file, in our order
};

// By name, since OpenEXR's come back sorted and may hold many layers: the colour, then the grey, then whatever comes first.
std::vector<int> chosen_channels(const oiio::ImageSpec& spec) {
    const auto named = [&](const char* name) { return spec.channelindex(name); };
    std::vector<int> chosen;
    if (named("R") >= 0 && named("G") >= 0 && named("B") >= 0) {
        chosen = {named("R"), named("G"), named("B")};
    } else if (named("Y") >= 0) {
        chosen = {named("Y")};
    } else {
        const int count = spec.nchannels >= 3 ? 3 : 1;
        for (int c = 0; c < count; ++c) {
            chosen.push_back(c);
        }
    }
    const int alpha = spec.alpha_channel >= 0 ? spec.alpha_channel : named("A");
    if (alpha >= 0 && std::find(chosen.begin(), chosen.end(), alpha) == chosen.end()) {
        chosen.push_back(alpha);
    }
    return chosen;
}

int integer_bits(const oiio::ImageSpec& spec) {
    if (spec.format.is_floating_point()) {
        return 0;
    }
    return static_cast<int>(spec.format.basesize()) * 8;
}

void* open_image(const char* path, const char* format, LancerImageHeader* header, void* receiver, LancerSink reason) try {
    auto reader = std::make_unique<Reader>();
    reader->path = path;
    reader->input = oiio::ImageInput::create(format);
    if (!reader->input) {
        say(receiver, reason, "this build of OpenImageIO can't read " + std::string(format) + " files: " + plain(oiio::geterror(), {}, ""));
        return nullptr;
    }
    oiio::ImageSpec config, spec;
    config.attribute("oiio:UnassociatedAlpha", 1);  // as stored
    if (!reader->input->open(path, spec, config)) {
        say(receiver, reason, plain(reader->input->geterror(), path, "it can't be opened"));
        return nullptr;
    }
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.deep) {
        say(receiver, reason, "it holds no flat picture");
        return nullptr;
    }
    reader->channels = chosen_channels(spec);
    *header = {spec.width, spec.height, static_cast<std::int32_t>(reader->channels.size()), integer_bits(spec), spec.image_bytes(true)};
    return reader.release();
} catch (const std::exception& error) {
    say(receiver, reason, error.what());
    return nullptr;
}

bool read_image(void* opaque, float* pixels, void* receiver, LancerSink reason) try {
    const Reader& reader = *static_cast<const Reader*>(opaque);
    oiio::ImageInput& input = *reader.input;
    const oiio::ImageSpec spec = input.spec();
    const auto [low, high] = std::minmax_element(reader.channels.begin(), reader.channels.end());
    const int first = *low, stored = *high - *low + 1, count = static_cast<int>(reader.channels.size());
    bool in_order = stored == count;
    for (int c = 0; c < count; ++c) {
        in_order = in_order && reader.channels[static_cast<std::size_t>(c)] == first + c;
    }
    if (in_order) {
        if (!input.read_image(0, 0, first, first + count, oiio::TypeDesc::FLOAT, pixels)) {
            say(receiver, reason, plain(input.geterror(), reader.path, "its pixels can't be read"));
            return false;
        }
        return true;
    }
    // Some other order: all that lie between, then pick.
    const std::size_t area = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<float> all(area * static_cast<std::size_t>(stored));
    if (!input.read_image(0, 0, first, first + stored, oiio::TypeDesc::FLOAT, all.data())) {
        say(receiver, reason, plain(input.geterror(), reader.path, "its pixels can't be read"));
        return false;
    }
    for (std::size_t i = 0; i < area; ++i) {
        for (const int channel : reader.channels) {
            *pixels++ = all[i * static_cast<std::size_t>(stored) + static_cast<std::size_t>(channel - first)];
        }
    }
    return true;
} catch (const std::exception& error) {
    say(receiver, reason, error.what());
    return false;
}

void close_image(void* reader) { delete static_cast<Reader*>(reader); }

// TIFF and JPEG know a few names only; what has no place of its own goes into the description, a line each.
void describe(oiio::ImageSpec& spec, const LancerImageToWrite& image) {
    std::string description;
    for (std::size_t i = 0; i < image.text_count; ++i) {
        const std::string key = image.texts[i].key;
        if (key == "Software" || key == "Artist" || key == "Copyright") {
            spec.attribute(key, image.texts[i].value);
        } else {
            if (!description.empty()) {
                description += '\n';
            }
            if (key != "Description") {
                description.append(key).append(": ");
            }
            description += image.texts[i].value;
        }
    }
    if (!description.empty()) {
        spec.attribute("ImageDescription", description);
    }
    spec.attribute("DateTime", "1970:01:01 00:00:00");  // left out, TIFF would get the time of writing
}

bool encode_image(const LancerImageToWrite* image, void* receiver, LancerSink bytes, void* reason_receiver, LancerSink reason) try {
    const auto fail = [&](const std::string& words) {
        say(reason_receiver, reason, words);
        return false;
    };
    const std::unique_ptr<oiio::ImageOutput> output = oiio::ImageOutput::create(std::string("picture.") + image->format);
    if (!output || !output->supports("ioproxy")) {
        return fail("this build of OpenImageIO can't write " + std::string(image->format) + " files");
    }
    const oiio::TypeDesc type = image->bytes ? oiio::TypeDesc::UINT8 : oiio::TypeDesc::FLOAT;
    oiio::ImageSpec spec(image->width, image->height, image->channels, type);
    if (std::string_view(image->format) == "jpeg") {
        spec.attribute("Compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else if (std::string_view(image->format) == "tiff") {
        spec.attribute("compression", "zip");
    }
    if (image->channels == 2 || image->channels == 4) {
        spec.alpha_channel = image->channels - 1;
        spec.channelnames.back() = std::string("A");
    }
    spec.attribute("oiio:ColorSpace", image->bytes ? "sRGB" : "Linear");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    describe(spec, *image);

    std::vector<unsigned char> buffer;
    oiio::Filesystem::IOVecOutput memory(buffer);
    if (!output->set_ioproxy(&memory) || !output->open(std::string("picture.") + image->format, spec)) {
        return fail(plain(output->geterror(), {}, "it can't be written"));
    }
    const void* pixels = image->bytes ? static_cast<const void*>(image->bytes) : image->floats;
    if (!output->write_image(type, pixels) || !output->close()) {
        return fail(plain(output->geterror(), {}, "it can't be written"));
    }
    bytes(receiver, reinterpret_cast<const char*>(buffer.data()), buffer.size());
    return true;
} catch (const std::exception& error) {
    say(reason_receiver, reason, error.what());
    return false;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const LancerImages lancer_images = {
    lancer_images_version, open_image, read_image, close_image, encode_image,
};
