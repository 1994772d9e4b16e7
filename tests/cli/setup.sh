#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# What the cases share: setup.sh PROGRAM SHARED makes a small room with truth, its result, and another cloud.
set -euo pipefail
program=$1 shared=$2
rm -rf "$shared"
mkdir -p "$shared"
"$program" synthesize -o "$shared/room.ply" --points 40000 --random-seed 5 -q
"$program" synthesize -o "$shared/other.ply" --points 1000 -q
"$program" segment "$shared/room.ply" -o "$shared/result" --no-pictures -q
# The same with the graph of another run.
"$program" segment "$shared/room.ply" -o "$shared/foreign" --no-pictures -q --edges.concavity_tolerance 1
cp "$shared/foreign/graph.vtp" "$shared/graph.vtp"
cp -r "$shared/result/." "$shared/foreign"
mv "$shared/graph.vtp" "$shared/foreign"

# A level plane of 1 x 1 m, and a cloud that is in millimetres: 3 x 3 m as 3000 x 3000.
plane() { # NAME SIZE
  awk -v size="$2" 'BEGIN {
    printf "ply\nformat ascii 1.0\nelement vertex 10000\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    for (i = 0; i < 100; ++i) for (j = 0; j < 100; ++j) print i * size / 100, j * size / 100, (i * 7 + j * 3) % 5 * size / 5000
  }' >"$shared/$1.ply"
}
plane plane 1
plane millimetres 3000
# A scanner's sentinel among the points.
sed 's/vertex 10000/vertex 10001/' "$shared/plane.ply" >"$shared/stray.ply"
echo '1e9 0 -1e9' >>"$shared/stray.ply"

# An RGB-D sequence, and what may be wrong with one.
"$program" synthesize --sequence 12 -o "$shared/frames" --points 20000 --random-seed 5 -q
break_as() { # NAME FRAMES: a copy with that many frames
  mkdir -p "$shared/$1/depth" "$shared/$1/image"
  cp "$shared/frames/camera.txt" "$shared/$1"
  for ((k = 0; k < $2; ++k)); do
    for part in depth image; do cp "$shared/frames/$part/0000$k.png" "$shared/$1/$part"; done
  done
  head -n $(($2 * 5)) "$shared/frames/trajectory.log" >"$shared/$1/trajectory.log"
}
break_as one_frame 1
break_as no_frames 0
break_as no_file 3 && rm "$shared/no_file/depth/00001.png" && ln -s nowhere "$shared/no_file/depth/00001.png"
break_as no_poses 3 && rm "$shared/no_poses/trajectory.log"
break_as standing 3 && rm "$shared/standing/trajectory.log"  # the same view three times, without poses
for part in depth image; do
  for k in 1 2; do cp "$shared/frames/$part/00000.png" "$shared/standing/$part/0000$k.png"; done
done
break_as bad_pose 3 && sed -i '8s/^[^ ]*/left/' "$shared/bad_pose/trajectory.log"
break_as lost 3 && sed -i '7,9s/^.*$/nan nan nan nan/' "$shared/lost/trajectory.log"
break_as all_lost 1 && sed -i '2,4s/^.*$/-inf -inf -inf -inf/' "$shared/all_lost/trajectory.log"
break_as truncated 3 && truncate -s 3000 "$shared/truncated/depth/00002.png"
break_as other_size 3 && sed -i '2s/^640 480/320 240/' "$shared/other_size/camera.txt"
break_as far_pose 2 && sed -i '7s/[^ ]*$/90000/' "$shared/far_pose/trajectory.log"
move() { # NAME LINE: half a metre along x, in line LINE of the poses
  awk -v line="$2" 'NR == line { $4 += 0.5 } { print }' OFMT=%.17g CONVFMT=%.17g \
    "$shared/$1/trajectory.log" >"$shared/moved.log"
  mv "$shared/moved.log" "$shared/$1/trajectory.log"
}
break_as loop_closed 9 && move loop_closed 7
break_as jump 3 && move jump 12
mkdir "$shared/no_snapshot" && seq 100 >"$shared/no_snapshot/snapshot.bin"
# Depth and poses that no time has in common.
mkdir -p "$shared/no_overlap/depth"
cp "$shared/frames/depth/00000.png" "$shared/no_overlap/depth"
echo "1.0 depth/00000.png" >"$shared/no_overlap/depth.txt"
echo "5.0 0 0 0 0 0 0 1" >"$shared/no_overlap/groundtruth.txt"
# Colours of another size (one pixel), cut off, and missing; poses of the other layouts that are no poses.
break_as other_color 3
base64 -d >"$shared/other_color/image/00001.png" <<<"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
break_as cut_color 3 && truncate -s 3000 "$shared/cut_color/image/00002.png"
break_as lost_color 3 && rm "$shared/lost_color/image/00001.png" && ln -s nowhere "$shared/lost_color/image/00001.png"
break_as color_depth 3 && cp "$shared/frames/image/00001.png" "$shared/color_depth/depth"
break_as empty_poses 3 && : >"$shared/empty_poses/trajectory.log"
mkdir -p "$shared/tum_pose" "$shared/scenes_pose"
cp -r "$shared/no_overlap/." "$shared/tum_pose" && echo "1.0 0 0 0 0 0 0" >"$shared/tum_pose/groundtruth.txt"
cp "$shared/frames/depth/00000.png" "$shared/scenes_pose/frame-000000.depth.png"
printf '1 0 0 0\n0 1 0 0\n0 0 one 0\n0 0 0 1\n' >"$shared/scenes_pose/frame-000000.pose.txt"

# A surfel map of the room: a disc of 2 cm each, every fourth of them less certain.
"$program" synthesize -o "$shared/room_text.ply" --points 40000 --random-seed 5 --normals --ascii -q
awk '/^property float z/ { print; print "property float radius"; print "property float confidence"; next }
     body { $3 = $3 " 0.02 " (NR % 4 ? 9 : 2); print; next }
     /^end_header/ { body = 1 } { print }' "$shared/room_text.ply" >"$shared/surfels.ply"
sed 's/ 0\.02 [29] / -1 nan /' "$shared/surfels.ply" >"$shared/no_surfels.ply"
sed '/^property float confidence/d; s/ 0\.02 [29] / 0.02 /' "$shared/surfels.ply" >"$shared/radii.ply"
