#!/usr/bin/env bash
# Generators of multi-spheres side by side: sets of 13 to 65 spheres for four ellipsoids, measured alike by
# `ellipsoid-post template`. Prints a table, a line for each set: shares of the ellipsoid's volume, surface and moments
# in percent, distances of the outlines in units of the smallest semi-axis; where spheres are equal, how many differ.
#
#   bash inputs/generators.sh            all sets, a minute
#   bash inputs/generators.sh oblate     those of shapes whose name begins so: prolate_2.35, prolate_5, oblate, triaxial
#
# inputs/generators/GENERATOR_SHAPE_N.csv are the sets of other generators, x y z r a line, the first line says which
# version and options made them. Add a file of that name to have one more.
set -euo pipefail
inputs="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
post="${ELLIPSOID_BIN:-$inputs/../build/bin}/ellipsoid-post"
wanted=${1-}
messages=$(mktemp)
trap 'rm -f "$messages"' EXIT

declare -A semiaxes=([prolate_2.35]="2.35 1 1" [prolate_5]="5 1 1" [oblate]="2.5 2.5 1" [triaxial]="2.5 1.75 1")
declare -A counts=([prolate_2.35]="13 33 65" [prolate_5]="13 25 33 65" [oblate]="13 33 65" [triaxial]="13 33 65")

# row GENERATOR SHAPE N OPTION...: a line of the table, or why there are no values
row() {
  local generator=$1 shape=$2 count=$3 found message
  shift 3
  # shellcheck disable=SC2086 # three numbers
  if ! found=$("$post" template --semiaxes ${semiaxes[$shape]} "$@" --csv - 2>"$messages"); then
    message=$(tail -n 1 "$messages")
    echo "| ${semiaxes[$shape]// / : } | $count | $generator | refused: ${message##*: } | | | | | | | | | |"
    return
  fi
  awk -F, -v shape="${semiaxes[$shape]// / : }" -v count="$count" -v generator="$generator" '
    NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k }
    function value(key) { return $(column[key]) }
    function share(key) { return sprintf("%+.2f", 100 * (value(key) - 1)) }
    NR == 2 {
      if (value("subspheres") != count) generator = generator " (" value("subspheres") " differ)"
      printf "| %s | %d | %s | %.2f | %s | %s | %.4f | %.4f | %.4f | %.4f | %s | %s | %s |\n", shape, count, generator,
        100 * value("in_exactly_one"), share("volume_ratio"), share("surface_ratio"), value("largest_to_spheres_c"),
        value("mean_to_spheres_c"), value("largest_to_body_c"), value("mean_to_body_c"), share("inertia_xx_ratio"),
        share("inertia_yy_ratio"), share("inertia_zz_ratio")
    }' <<<"$found"
}

echo "| a : b : c | N | generator | in exactly one | volume | surface | to spheres, largest | mean |" \
  "to outline, largest | mean | I_xx | I_yy | I_zz |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
for shape in prolate_2.35 prolate_5 oblate triaxial; do
  [[ $shape == "$wanted"* ]] || continue
  ours="medial minimax_volume"
  [[ $shape == prolate* ]] && ours="paper minimax_outline minimax_area $ours"
  for count in ${counts[$shape]}; do
    for generator in Favier Ferellec_McDowell Euclid3D MSS; do
      list="$inputs/generators/${generator}_${shape}_$count.csv"
      [[ ! -e $list ]] || row "${generator/_/, }" "$shape" "$count" --clump "$list"
    done
    for spacing in $ours; do
      row "\`$spacing\`" "$shape" "$count" --subspheres "$count" --spacing "$spacing"
    done
  done
done
