# run.sh BATCH SCENE [VARIANTS [ARGS]] : runs of BATCH (one trace), results in r5/
. /work/w/h4/exp/env.sh
b=$1; s=$2; v=${3:-0}; shift 3
cd /work/w/h4/exp/r5
export X_VARIANTS=$v X_CACHE=/work/w/h4/exp/r5/$s.$v.trace X_BATCH=/work/w/h4/exp/r5/$b
[ -n "$TAG" ] && X_CACHE=/work/w/h4/exp/r5/$s.$v.$TAG.trace
[ -e $X_CACHE ] || export X_DUMP=/work/w/h4/exp/r5/$s.$v$TAG
date +%T
/usr/bin/time -f "$s %e s %U s %M KB" ${PR:-/work/w/h4/exp/pr} model ${A[$s]} "$@" --json
date +%T
