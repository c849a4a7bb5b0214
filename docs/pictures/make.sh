#!/usr/bin/env bash
# Renders the pictures of the documentation again, with the program that ./run has built, or with the one that LANCER names.
#   docs/pictures/make.sh            all of them: some minutes
#   docs/pictures/make.sh prism ...  some, by name
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
lancer=${LANCER:-build/release/lancer}
[ -x "$lancer" ] || { echo "There is no $lancer yet; ./run --help builds it." >&2; exit 1; }

wanted=("$@")
# picture NAME SCENE [OPTION...]
picture() {
    local name=$1 scene=$2
    shift 2
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $name "* ]] || return 0
    case $scene in
    *.*) scene=scenes/$scene ;;
    *) scene=scenes/$scene.toml ;;
    esac
    "$lancer" render "$scene" -o "docs/pictures/$name.png" --checkpoint off --progress plain "$@" 2>/dev/null
}

# flip NAME PICTURE REFERENCE: the map of what differs between two pictures of this folder
flip() {
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $1 "* ]] || return 0
    "$lancer" compare "docs/pictures/$2.png" "docs/pictures/$3.png" --flip-image "docs/pictures/$1.png" > /dev/null
}

small=(--size 640x360)
picture figure-1 report/figure-1 --size 960x540
for camera in fov-90 fov-130 level; do
    picture "$camera" report/figure-1 --camera "$camera" --size 480x270
done
picture low-angle report/figure-1 --camera low-angle --size 480x360
for bounces in 0 1 2 5; do
    picture "bounces-$bounces" report/figure-1 --bounces "$bounces" --size 480x270
done
picture one-light report/lights --lights left "${small[@]}"
picture three-lights report/lights "${small[@]}"
picture first first --size 640x360
picture aliased features/adaptive --aa uniform --ssaa 1 --size 480x270
picture ssaa-4 features/adaptive --aa uniform --ssaa 4 --size 480x270
flip flip-aliasing aliased ssaa-4
picture adaptive features/adaptive --size 480x270 --sample-map docs/pictures/adaptive-samples.png
picture prism features/prism --size 960x540
for feature in sphere box plane disk cylinder cone mesh-inline mesh-obj mesh-ply transforms groups materials transparency absorption glasses \
    checker image-texture texture-options light-point light-spot light-directional background camera glass-spheres nested-glass dispersion; do
    picture "$feature" "features/$feature" "${small[@]}"
done
picture camera-wide features/camera --camera wide --size 480x270
picture camera-tele features/camera --camera tele --size 480x270
for scene in sphereflake chess glassware city; do
    picture "$scene" "gallery/$scene" "${small[@]}"
done
for scene in metals clear-bodies plastics principled facets burley depth-of-field lamps many-lights sky fog-overlap; do
    picture "$scene" "features/$scene" "${small[@]}" --spp 512
done
for scene in fog-balls light-ies; do
    picture "$scene" "features/$scene" "${small[@]}" --spp 1024
done
picture goniometric features/goniometric "${small[@]}" --integrator bdpt --spp 48
picture projector features/projector "${small[@]}" --integrator bdpt --spp 64
picture fog-cloud features/fog-cloud "${small[@]}" --spp 512
picture fog-flame features/fog-flame --size 480x480 --spp 1024
picture metamers features/metamers --size 960x400
picture environment features/environment "${small[@]}"
for samples in emitter bsdf mis; do
    picture "direct-$samples" features/direct-light --direct-samples "$samples" --size 480x320
done
for scene in mapping masks mixes bumps vertex-colors; do
    picture "$scene" "features/$scene" "${small[@]}"
done
picture cornell-box gallery/cornell-box --size 480x480
for view in srgb pbr-neutral agx aces; do
    picture "view-$view" gallery/cornell-box --size 240x240 --spp 1024 --exposure 2 --view "$view"
done

# What stands beside the picture, made visible by oiiotool (Debian: openimageio-tools).
aovs=$(mktemp --suffix=.exr)
trap 'rm -f "$aovs"' EXIT
# aov NAME CHANNELS [STEP...]: a picture of some channels
aov() {
    local name=$1 channels=$2
    shift 2
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" aov-$name "* ]] || return 0
    if ! command -v oiiotool >/dev/null; then
        echo "aov-$name is left as it is: there is no oiiotool" >&2
        return 0
    fi
    [ -s "$aovs" ] || "$lancer" render scenes/gallery/cornell-box.toml --size 240x240 --spp 2048 --aov albedo,normal,direct,indirect -o "$aovs" --quiet
    oiiotool "$aovs" --ch "$channels" "$@" -d uint8 -o "docs/pictures/aov-$name.png"
}
encoded=(--colorconvert linear sRGB)
aov albedo albedo.R,albedo.G,albedo.B "${encoded[@]}"
aov normal normal.X,normal.Y,normal.Z --mulc 0.5 --addc 0.5
aov direct direct.R,direct.G,direct.B --mulc 2 "${encoded[@]}"
aov indirect indirect.R,indirect.G,indirect.B --mulc 2 "${encoded[@]}"
[ ${#wanted[@]} -gt 0 ] && [[ " ${wanted[*]} " != *" mitsuba "* ]] ||
    "$lancer" render scenes/mitsuba/still-life.xml -o docs/pictures/mitsuba.png --size 640x360 --checkpoint off --progress plain 2>/dev/null
[ ${#wanted[@]} -gt 0 ] && [[ " ${wanted[*]} " != *" pbrt "* ]] ||
    "$lancer" render scenes/pbrt/still-life.pbrt -o docs/pictures/pbrt.png --size 640x360 --checkpoint off --progress plain 2>/dev/null
picture gltf gltf/still-life.glb --size 480x320 --spp 96

for time in morning noon dusk; do
    picture "pavilion-$time" "gallery/pavilion-$time" "${small[@]}" --spp 256
done
picture night-city gallery/night-city "${small[@]}" --spp 128
picture light-shafts gallery/light-shafts "${small[@]}" --spp 1024
for scene in metal-samples chess-focus diamonds daylight-room; do
    picture "$scene" "gallery/$scene" "${small[@]}" --spp 192
done
picture still-life gallery/still-life "${small[@]}" --spp 192
for scene in goblets flacon; do
    picture "$scene" "gallery/$scene" --size 480x480 --spp 192
done

# Light from the lamps
picture prism-rainbow gallery/prism "${small[@]}" --spp 144
picture ring gallery/ring "${small[@]}" --spp 256
picture diamond-fire gallery/diamond-fire "${small[@]}" --spp 144
picture pool gallery/pool "${small[@]}" --spp 64
picture wine-glass gallery/wine-glass --size 400x400 --spp 128
# same_seconds SCENE [OPTION...]: what each integrator makes of 16 seconds of processor, SCENE-INTEGRATOR.png, and a table of errors against a reference
# that takes minutes.
same_seconds() {
    local scene=$1
    shift
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $scene "* ]] || return 0
    LANCER=$lancer benchmarks/integrators.py "scenes/features/$scene.toml" --seconds 16 --reference 260 --integrators path,light,bdpt,vcm \
        --pictures docs/pictures "$@"
}
same_seconds both-ends --sds
same_seconds fog-beam
same_seconds caustic-in-mirror --sds
# film NAME SCENE FRAMES COLUMNSxROWS [OPTION...]: frames of an animation, side by side
film() {
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $1 "* ]] || return 0
    local name=$1 scene=$2 frames=$3 grid=$4 folder
    shift 4
    folder=$(mktemp -d)
    "$lancer" render "scenes/$scene" --frames "$frames" -o "$folder/f.####.png" --quiet "$@"
    ffmpeg -v error -y -pattern_type glob -i "$folder/f.*.png" -vf "tile=$grid" "docs/pictures/$name.png"
    rm -r "$folder"
}
film carousel gltf/carousel.gltf 0:84:12 4x2 --size 240x135 --spp 192
film pool-frames gallery/pool.toml 0:36:12 2x2 --size 320x180 --spp 32
