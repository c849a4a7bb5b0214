#include "lancer/image/images_module.h"

#include "lancer/image/modules.h"

namespace lancer {

const LancerImages& load_images_module(const std::vector<std::string>& folders) {
    static constexpr ModuleWords words = {"lancer_images.so",
                                          "lancer_images",
                                          "OpenImageIO",
                                          "libopenimageio2.4",
                                          "the part of lancer that reads images other than PNG and writes JPEG and TIFF",
                                          "libopenimageio-dev"};
    return *static_cast<const LancerImages*>(find_module(words, lancer_images_version, folders));
}

const LancerImages& images_module() {
    static const LancerImages& module = load_images_module(module_folders());
    return module;
}

}  // namespace lancer
