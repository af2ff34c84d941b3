# run.sh BATCH SCENE... : trace (or its file) and the runs of BATCH_SCENE.txt
. /work/w/h4/exp/env.sh
b=$1; shift
for s in "$@"; do
  export X_VARIANTS=3500 X_CACHE=/work/w/h4/exp/rules/$s.trace X_BATCH=/work/w/h4/exp/rules/${b}_$s.txt
  unset X_DUMP; [ -e $X_CACHE ] || export X_DUMP=/work/w/h4/exp/rules/$s
  /usr/bin/time -f "$s %U s %M KB" nice -n 15 /work/w/h4/exp/pr model ${A[$s]} --json
done
