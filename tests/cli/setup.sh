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
