# run0.sh BATCH SCENE VARIANTS
. /work/w/h4/exp/env.sh
b=$1; v=${3:-0}
case $2 in showroom) list="statue showroom";; *) exit 0;; esac
for s in $list; do
export X_VARIANTS=$v X_CACHE=/work/w/h4/exp/rules/$s.$v.trace X_BATCH=/work/w/h4/exp/rules/${b}_$s.txt X_DUMP=/work/w/h4/exp/rules/$s.$v
[ -e $X_CACHE ] && unset X_DUMP
/usr/bin/time -f "$s %U s %M KB" /work/w/h4/exp/pr model ${A[$s]} --json
done
