// Mattes of objects and materials that compositors pick by name [Friedman and Jones 2015], version 1.2 of the specification.
//
// A pixel holds pairs of an id and the share of the pixel that it covers, the largest first, two pairs in the channels R, G, B, A of each of the
// layers "NAME00", "NAME01", ...: id, coverage, id, coverage. Ids are the bits of a hash of the name taken as a float, so these channels must be
// stored as float32, losslessly.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lancer/image/layers.h"

namespace lancer {

// MurmurHash3, the 32-bit variant [Appleby 2011].
std::uint32_t murmur3_32(std::string_view bytes, std::uint32_t seed = 0);

// The id of a name: its hash, with one bit of the exponent turned where the float would not be an ordinary number.
std::uint32_t cryptomatte_bits(std::string_view name);
float cryptomatte_id(std::string_view name);

// What stands in the file's header: "cryptomatte/KEY/name", "hash", "conversion", and "manifest", the JSON of all names and ids, sorted.
// `layer` is what the layers' names begin with: "CryptoObject".
Metadata cryptomatte_metadata(const std::string& layer, const std::vector<std::string>& names);

// What covers a pixel: ids and how much of it each covers, 0 to 1.
using Coverage = std::vector<std::pair<float, float>>;

// The channels of `levels` pairs (an even number, at least 2) for each of the pixels, row-major: the largest are kept, equal ones in the order
// of their ids' bits. `pixels` has width * height entries.
std::vector<Channel> cryptomatte_channels(const std::string& layer, int levels, const std::vector<Coverage>& pixels);

}  // namespace lancer
