// Pictures that a reader makes itself, such as mixtures of others.
#pragma once

#include "lancer/image/image.h"
#include "lancer/scene/textures.h"

namespace lancer {

// The pixels as a picture in memory, of linear colours as they are, under a name that no other picture has. Three channels.
scene::ImageTexture made_picture(const Image& rgb, const SourcePosition& position);

}  // namespace lancer
