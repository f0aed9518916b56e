#!/bin/sh
# Draws the pictures of README.md with the program itself.
set -eu
cd "$(dirname "$0")/.."
out=docs/pictures
editor=${EDITOR_PROGRAM:-./editor}
mkdir -p "$out"
"$editor" render builtin:showcase --ui --size 1280x800 --samples 4 -o "$out/window.png"
"$editor" render builtin:mannequin-4 --look studio --samples 4 --size 640x480 -o "$out/textured.png"
"$editor" render builtin:mannequin-6 --samples 4 --size 640x480 -o "$out/mannequin.png"
"$editor" render builtin:mannequin-5 --ui --tool pose --drag 240,280,150,180 --size 1000x700 \
    --samples 4 -o "$out/dragging.png"
"$editor" render builtin:adult --pose builtin:adult-walk --look studio --camera 62,14,1.9,0,0.3,0 --ui \
    --press K --drag 555,230,555,230 --size 1280x800 --samples 4 -o "$out/explain.png"
"$editor" render builtin:adult --pose builtin:adult-walk --display both --look studio \
    --camera 55,8,2.6 --samples 4 --size 640x480 -o "$out/both.png"
"$editor" render builtin:adult --pose builtin:adult-walk --display skeleton \
    --camera 55,8,2.6 --samples 4 --size 640x480 -o "$out/skeleton.png"
"$editor" render builtin:knot --curve frames --surface off --fit --camera 70,35,5 --samples 4 \
    --size 640x480 -o "$out/frames.png"
"$editor" render builtin:scenes/turned --samples 4 \
    --size 640x480 -o "$out/surface.png"
"$editor" render builtin:creature --pose builtin:creature-wave --look studio --fit \
    --camera 75,10,4 --samples 4 --size 640x480 -o "$out/creature.png"
"$editor" render builtin:face --pose builtin:face-wink --look studio --camera 78,5,2.7 --samples 4 \
    --size 640x480 -o "$out/face.png"
# What cutting the weights of a vertex to the largest four changes.
"$editor" render builtin:adult --pose builtin:adult-walk --camera 90,0,2.4 --size 480x480 -o "$out/a.png"
"$editor" render builtin:adult --pose builtin:adult-walk --camera 90,0,2.4 --size 480x480 \
    --influences 4 -o "$out/b.png"
"$editor" compare "$out/a.png" "$out/b.png" -o "$out/compare.png" || true
rm "$out/a.png" "$out/b.png"
